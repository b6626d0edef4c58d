CREATE TABLE archive_property (name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT;
INSERT INTO archive_property VALUES('schema_version','1');
INSERT INTO archive_property VALUES('writer','00000000-0000-4000-8000-0000000000aa');
CREATE TABLE recipe (sha256 TEXT PRIMARY KEY, content TEXT NOT NULL) STRICT;
INSERT INTO recipe VALUES('aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa','{"limits":[0.05],"name":"seat"}');
CREATE TABLE evaluation (
    uuid TEXT PRIMARY KEY, writer TEXT NOT NULL, sequence INTEGER NOT NULL CHECK (sequence > 0),
    previous_hash TEXT NOT NULL, hash TEXT NOT NULL, recorded_at TEXT NOT NULL,
    person TEXT, instrument TEXT, calibrated_on TEXT,
    task TEXT NOT NULL, version TEXT NOT NULL, recipe_sha256 TEXT NOT NULL, recipe_content_sha256 TEXT,
    key TEXT NOT NULL, exit_code INTEGER NOT NULL, verdict TEXT, supersedes TEXT, reason TEXT,
    inputs TEXT NOT NULL, result TEXT NOT NULL, UNIQUE (writer, sequence)) STRICT;
INSERT INTO evaluation VALUES('00000000-0000-4000-8000-000000000001','00000000-0000-4000-8000-0000000000aa',1,'0000000000000000000000000000000000000000000000000000000000000000','012ecb0efb6d4ad2217cf644b53bf1f532654fba7ac299250ef895e141f04413','2026-11-28T12:00:01.000Z','A. Nowak','scanner 7','2026-03-01','compare','0.2.0','aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa','48bffc5de8d87807ec4635477f6af59a0a7e53cc9f8b662d94ef539188345b3a','ef542d5e62b5f59611b3cb8e1270a7776f6ce15425ba0500c178f1021ba427f5',0,'pass',NULL,NULL,'[{"role":"copy","path":"/parts/part_1.ply","bytes":1001,"sha256":"501f1672fe082a4379e4ce7d0f21a3e8550c8439bf4f9ec4323d76ac2dd197d1"}]','{"inputs":[{"path":"/parts/part_1.ply"}],"rmse_mm":0.0121,"zones":[{"name":"seat","mean_mm":0.001,"uncertainty_mm":0.002,"lower_mm":-0.05,"upper_mm":0.05,"verdict":"pass"}]}');
INSERT INTO evaluation VALUES('00000000-0000-4000-8000-000000000002','00000000-0000-4000-8000-0000000000aa',2,'012ecb0efb6d4ad2217cf644b53bf1f532654fba7ac299250ef895e141f04413','9c06517a28485e6073d85cfc24596a068cf611f794a337a51e85fd2449b5ead6','2026-11-28T12:00:02.000Z','A. Nowak','scanner 7','2026-03-01','compare','0.2.0','aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa','48bffc5de8d87807ec4635477f6af59a0a7e53cc9f8b662d94ef539188345b3a','bf56e689142869d75775a362d98c472918002212833b0baff6a07c7f32425db6',0,'pass',NULL,NULL,'[{"role":"copy","path":"/parts/part_2.ply","bytes":1002,"sha256":"47912032f511cab1c14f9dcf22b2ea8c5a47bf85a03c903adfc7bcad1fcebafc"}]','{"inputs":[{"path":"/parts/part_2.ply"}],"rmse_mm":0.0122,"zones":[{"name":"seat","mean_mm":0.002,"uncertainty_mm":0.002,"lower_mm":-0.05,"upper_mm":0.05,"verdict":"pass"}]}');
INSERT INTO evaluation VALUES('00000000-0000-4000-8000-000000000003','00000000-0000-4000-8000-0000000000aa',3,'9c06517a28485e6073d85cfc24596a068cf611f794a337a51e85fd2449b5ead6','3476133b14a3c18b4baa3977d2b98ec2912812ce2b17530e8575aff3dd7e4222','2026-11-28T12:00:03.000Z','A. Nowak','scanner 7','2026-03-01','compare','0.2.0','aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa','48bffc5de8d87807ec4635477f6af59a0a7e53cc9f8b662d94ef539188345b3a','7e83dcdce14232c3a72b62738567a84fdefe5fae8246a4e601d9701a04241877',0,'fail',NULL,NULL,'[{"role":"copy","path":"/parts/part_3.ply","bytes":1003,"sha256":"7c2b5abbd8d2ba0bb1e0a9e21a4527ab0b284b7c482640ce9d34cc726ab76dad"}]','{"inputs":[{"path":"/parts/part_3.ply"}],"rmse_mm":0.0123,"zones":[{"name":"seat","mean_mm":0.003,"uncertainty_mm":0.002,"lower_mm":-0.05,"upper_mm":0.05,"verdict":"fail"}]}');
CREATE TABLE characteristic (
    id INTEGER PRIMARY KEY, task TEXT NOT NULL, key TEXT NOT NULL, unit TEXT NOT NULL,
    UNIQUE (task, key, unit)) STRICT;
INSERT INTO characteristic VALUES(1,'compare','answer','mm');
INSERT INTO characteristic VALUES(2,'compare','rmse_mm','mm');
INSERT INTO characteristic VALUES(3,'compare','zones.seat.mean_mm','mm');
CREATE TABLE measured (
    characteristic INTEGER NOT NULL REFERENCES characteristic (id), recorded_at TEXT NOT NULL,
    sequence INTEGER NOT NULL, evaluation TEXT NOT NULL REFERENCES evaluation (uuid), place INTEGER NOT NULL, value REAL NOT NULL,
    expanded_uncertainty REAL, lower_limit REAL, upper_limit REAL, verdict TEXT, file TEXT NOT NULL,
    PRIMARY KEY (characteristic, recorded_at, sequence, evaluation, place)) STRICT, WITHOUT ROWID;
INSERT INTO measured VALUES(1,'2026-11-28T12:00:01.000Z',1,'00000000-0000-4000-8000-000000000001',1,0.04100000000000000172,0.0020000000000000000416,-0.050000000000000002775,0.050000000000000002775,'pass','part_1.ply');
INSERT INTO measured VALUES(1,'2026-11-28T12:00:02.000Z',2,'00000000-0000-4000-8000-000000000002',1,0.042000000000000002609,0.0020000000000000000416,-0.050000000000000002775,0.050000000000000002775,'pass','part_2.ply');
INSERT INTO measured VALUES(1,'2026-11-28T12:00:03.000Z',3,'00000000-0000-4000-8000-000000000003',1,0.043000000000000003497,0.0020000000000000000416,-0.050000000000000002775,0.050000000000000002775,'fail','part_3.ply');
INSERT INTO measured VALUES(2,'2026-11-28T12:00:01.000Z',1,'00000000-0000-4000-8000-000000000001',2,0.012099999999999999644,NULL,NULL,NULL,NULL,'part_1.ply');
INSERT INTO measured VALUES(2,'2026-11-28T12:00:02.000Z',2,'00000000-0000-4000-8000-000000000002',2,0.012200000000000000774,NULL,NULL,NULL,NULL,'part_2.ply');
INSERT INTO measured VALUES(2,'2026-11-28T12:00:03.000Z',3,'00000000-0000-4000-8000-000000000003',2,0.012300000000000000169,NULL,NULL,NULL,NULL,'part_3.ply');
INSERT INTO measured VALUES(3,'2026-11-28T12:00:01.000Z',1,'00000000-0000-4000-8000-000000000001',3,0.0010000000000000000208,0.0020000000000000000416,-0.050000000000000002775,0.050000000000000002775,'pass','part_1.ply');
INSERT INTO measured VALUES(3,'2026-11-28T12:00:02.000Z',2,'00000000-0000-4000-8000-000000000002',3,0.0020000000000000000416,0.0020000000000000000416,-0.050000000000000002775,0.050000000000000002775,'pass','part_2.ply');
INSERT INTO measured VALUES(3,'2026-11-28T12:00:03.000Z',3,'00000000-0000-4000-8000-000000000003',3,0.0030000000000000000624,0.0020000000000000000416,-0.050000000000000002775,0.050000000000000002775,'fail','part_3.ply');
CREATE INDEX evaluation_time ON evaluation (recorded_at, sequence, uuid);
CREATE INDEX evaluation_key ON evaluation (key);
CREATE INDEX evaluation_supersedes ON evaluation (supersedes) WHERE supersedes IS NOT NULL;
CREATE TRIGGER evaluation_again BEFORE INSERT ON evaluation
    WHEN EXISTS (SELECT 1 FROM evaluation WHERE uuid = new.uuid)
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER evaluation_update BEFORE UPDATE ON evaluation
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER evaluation_delete BEFORE DELETE ON evaluation
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER measured_update BEFORE UPDATE ON measured
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER measured_delete BEFORE DELETE ON measured
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER recipe_update BEFORE UPDATE ON recipe
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER recipe_delete BEFORE DELETE ON recipe
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER characteristic_update BEFORE UPDATE ON characteristic
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
CREATE TRIGGER characteristic_delete BEFORE DELETE ON characteristic
    BEGIN SELECT RAISE(ABORT, 'the archive is append-only'); END;
PRAGMA user_version = 1;
