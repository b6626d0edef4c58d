<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>lathelier::Form</name>
    <message numerus="yes">
        <source>More (%n assumed)</source>
        <translation>
            <numerusform>More (%n assumed)</numerusform>
            <numerusform>More (%n assumed)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lathelier::InputBox</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lathelier::NotesChips</name>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n warning</numerusform>
            <numerusform>%n warnings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n note</numerusform>
            <numerusform>%n notes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lathelier::chain_panel::ChainRunRow</name>
    <message numerus="yes">
        <source>Run %n step(s)…</source>
        <translation>
            <numerusform>Run %n step…</numerusform>
            <numerusform>Run %n steps…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::ExercisePane</name>
    <message numerus="yes">
        <source>%n answer(s)</source>
        <translation>
            <numerusform>%n answer</numerusform>
            <numerusform>%n answers</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Listen (%n left)</source>
        <translation>
            <numerusform>Listen (%n left)</numerusform>
            <numerusform>Listen (%n left)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::TourPane</name>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n step</numerusform>
            <numerusform>%n steps</numerusform>
        </translation>
    </message>
</context>
</TS>
