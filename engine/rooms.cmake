# The rooms of the engine, one folder each, and which others each may use besides itself: the link of their libraries
# (engine/CMakeLists.txt) and the check of their includes (tests/layers.cmake) both follow this list.
# room(name [USES rooms…] [LINKS libraries…])
room(core LINKS nlohmann_json::nlohmann_json TBB::tbb fmt::fmt Boost::headers Threads::Threads)
room(signal USES core)
room(report USES core LINKS fmt::fmt ZLIB::ZLIB)
room(io USES core LINKS fmt::fmt OpenSSL::Crypto)
room(form USES core signal io report)
room(trajectory USES core signal io report form LINKS fmt::fmt)
room(registration USES core io report LINKS CGAL::CGAL fmt::fmt)
room(verify USES core report form registration LINKS fmt::fmt)
room(project USES core io)
room(sample USES core io form registration project LINKS fmt::fmt)
