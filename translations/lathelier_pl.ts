<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl" sourcelanguage="en">
<context>
    <name>Engine</name>
    <message>
        <source>The option {option} is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{parameter} is {found}; expected {expected} from {minimum} to {maximum}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{parameter}: found “{found}”, expected {expected}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This file does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be read: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected a file, found {found}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file cannot be written: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kind of this file is not known; expected {expected}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found “{found}”, expected {expected}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file ends early: {found} of {expected} {items} are there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“{found}” can be read in two ways: {first} or {second}. State the decimal mark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file states no unit, and an extent of {extent} fits no guess. State the unit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds no usable point.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The coordinate {found} is out of reach; expected at most {maximum}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{found} points are too few; at least {minimum} are needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The points all lie {found}; this determines no alignment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The two parts do not match: only {overlap_percent} % of the copy lies near the reference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stable solution after {iterations} iterations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {role} is not a body of revolution (residual {residual_mm} mm).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lathelier made a mistake here ({reason}). Please report it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has format version {found}; this program reads up to version {maximum}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: no unit is stated; read as {unit} because of its extent of {extent}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {count} rows were skipped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {count} points without finite coordinates were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll about the axis is not determined by the geometry; the smallest rotation was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A {kind} is not determined by the geometry; the initial pose was kept along it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A {kind} is only weakly determined by the geometry.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method chosen: {method} ({reason}).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The copy was turned end for end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} points further than {distance_mm} mm from the reference were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} points in the excluded zones were left out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inside and outside are not known (no normals, no closed surface): the deviation has no sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The difference cannot be told from the scanner&apos;s accuracy of {scanner_accuracy_mm} mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} has changed since the project was saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one of the choices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ranges such as 10:20,35:40</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column {column}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>byte {byte}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a socket</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the pipe delivers more than 4 GiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nobody writes into this pipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no permission</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk quota is used up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the file would be too large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder does not exist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its links go round in a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved {path}.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::EmptyState</name>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::FieldEditor</name>
    <message>
        <source>not given</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::Form</name>
    <message>
        <source>Advanced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::HeadlineLabel</name>
    <message>
        <source>✓ within tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::InputBox</name>
    <message>
        <source>%L1 triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1 (assumed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 rows skipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⚠ This file could not be read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a file as “%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take “%1” away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How to read this file: unit, decimal mark, columns</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::IntervalsEdit</name>
    <message>
        <source>Add a range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this range</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::NotesLabel</name>
    <message>
        <source>Fewer notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::NumberEdit</name>
    <message>
        <source>Expected a whole number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected a number from %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::PanelBase</name>
    <message>
        <source>Open: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take away: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change how to read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take out of the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still missing: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. Change an input or press F5 to compute again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::ProgressRow</name>
    <message>
        <source>Stopping…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save pictures and data of this result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make this result part of the project&apos;s report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a report of this result as HTML or PDF</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
