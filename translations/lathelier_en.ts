<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
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
        <source>The points all lie {found}; no answer follows from that.</source>
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
    <message>
        <source>The kind of this file is not known: found {found}, expected {expected}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {announced} rows are announced, {found} are there; all were read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the file states {unit}; the given unit {given} is not used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a byte that is no UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decimal mark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How text files write decimals; automatic asks when 1,234 could be a thousand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tabulator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Separator</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stands between the columns of a text file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Encoding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How a text file stores its characters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit of a file that states none. A stated unit always rules.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the index of a vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an OBJ keyword such as v or f</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three corners or more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one value for each of the FIELDS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ascii, binary or binary_compressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points of at most 1 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FIELDS with x, y and z before this line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>POINTS or WIDTH and HEIGHT before this line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1, 2, 4 or 8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F, I or U</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line of a PCD header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line DATA</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real numbers of 4 or 8 bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>damaged compressed data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>data in LZF compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a PLY type such as float or uchar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ascii, binary_little_endian or binary_big_endian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whole-number PLY type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of the property</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line that states the format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line of a PLY header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end_header</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertices with the properties x, y and z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an element vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a ZIP archive or an Office document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a 7z archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a zstd archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an xz archive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an E57 scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a LAS scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a STEP file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a VTK file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an OFF mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an RTF document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an XML document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an HTML document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a database</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points as text, PLY, PCD, STL or OBJ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>binary data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>endsolid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>endloop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>column names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text without rows of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number with a decimal comma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blank line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fewer columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more columns of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text below the rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a row of numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line of at most 1 MiB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns named x, y and z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one unit for x, y and z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most 32 levels of nesting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a project of at most 64 MB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>true or false</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number, a text, true, false, null or ranges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Lathelier project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a format version from 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanning the original</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanning the copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in one place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in a plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distances from cloud to cloud</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis of the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axis of the copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Body of revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point to plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point to point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the copy is aligned; automatic takes the axis of a body of revolution.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the part is a body of revolution.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As scanned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initial pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic finds any pose; as scanned searches near the given one only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance ±</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest deviation allowed to either side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pass from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of points that must lie within the tolerance.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanner accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One standard deviation of the scanner.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Excluded zones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamping areas along the axis, counted from the reference&apos;s first data.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>translation along the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the axis, from the first data (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle about the axis (°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation along the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>± one standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meridian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>original</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy, deviation × {factor}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Histogram of the deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>body of revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point to plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point to point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation of the copy from the original&apos;s surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robust standard deviation (MAD)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % of the points lie between</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>… and</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % of the sizes lie below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance, plus and minus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share within tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share needed to pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: no tolerance was given</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scanner&apos;s accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference told from the scanner&apos;s accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlap (points of the copy that were used)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zones along the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>std. dev. (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Converged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty along the axis (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty, largest direction (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty across the axis (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty across it (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of the axis&apos;s direction (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of the rotation (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearest-point figure, as in the source paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cloud-to-cloud RMSE</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its floor: what sampling alone gives</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motions the geometry does not determine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direction x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>through x (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>translation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the copy&apos;s coordinates to the original&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shift (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations are measured along the normal of the original&apos;s surface; plus means material in excess.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations are distances from the original&apos;s surface, without a sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How sure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cloud-to-cloud figure mixes the difference of the parts with the distance between neighbouring points: even identical parts reach its floor. The deviation from the surface does not depend on it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean {mean} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{share} % within ±{tolerance} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparison of a copy with its original</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method and parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a name in .ply or .csv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Input files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>en</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Synthetic data: made by a program, not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writing deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delimiter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest x, y, z (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest x, y, z (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skipped line {line}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was understood of the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no result to report yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has nothing to report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roundness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chatter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan or mesh of the original</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scan of the part to be judged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point clouds and meshes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop two scans here, first the original, then the copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the system refused it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Original (blue) and copy (red), oblique</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Original (blue) and copy (red), from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation of the copy, oblique</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation of the copy, from the side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: synthetic data, made by a program, not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a shorter statement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unrolled surface: tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unrolled surface: form of the deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} poses fit equally well; the one with the smallest rotation was chosen.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>symmetry is not to be used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference is not a body of revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>both parts are bodies of revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the copy is not a body of revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a body of revolution, which has an axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>root mean square error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>peak-to-valley roundness deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>peak-to-reference roundness deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference-to-valley roundness deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>root mean square roundness deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>peak-to-valley cylindricity deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least squares reference circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>minimum zone reference circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maximum inscribed reference circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>minimum circumscribed reference circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least squares reference cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>minimum zone reference cylinders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undulations per revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>median absolute deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The columns cannot be told: found “{found}”, expected {expected}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file holds deviations only, from {minimum} to {maximum}. State the nominal radius.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The record is not complete: {partner} is not beside it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The record contradicts itself ({check}): found {found}, expected {expected}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the points lie in the plane {plane} at {at_mm} mm; read as a profile in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {coordinate} runs from {from_mm} to {to_mm} mm; all points were read as one section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the columns have no names; read as {columns}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: no unit of the angle is stated; read as rad because it runs over {extent}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: no angles are stated; {count} values were spread evenly over one turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: deviations laid on the nominal radius of {radius_mm} mm; the size is not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the file holds radii; the nominal radius of {radius_mm} mm is not used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: no unit of the time is stated; read as seconds.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the times are written too coarsely; {rate_hz} frames a second were used instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: neither times nor a rate are stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: no unit of {channel} is stated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the stated converter rate of {stated_kHz} kHz does not fit {channels} channels; {used_kHz} kHz was used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the stated delay of {stated_ms} ms does not fit the rates; {used_ms} ms from channel to channel was used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {full_scale_code} converter codes of {device} were read as {volts} V.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the recorder {device} is not known; the values are converter codes. State the full scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the recording has {count} segments; there may be gaps between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value, for a decision with uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest cylindricity deviation CYLt allowed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With uncertainty (ISO 14253-1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simple compares the value alone; the other passes or fails only what is sure.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty of a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One standard deviation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size of the .dat file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full-scale code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Converter code of the full-scale voltage at gain 1; by default the recorder&apos;s own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full-scale voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Voltage of the full-scale code at gain 1; by default the recorder&apos;s own.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 to 32</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gain code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0 to 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>active channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples = frames × channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frames, stated twice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total time = frames / rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>converter rate ≥ rate × channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another signature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the .par file of an L-Graph record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size of the .par file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rate per channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a probe record as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>displacements in units of length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns named X3, Y3, Xp and Yp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at most 10000 sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one z for a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a later time than in the row before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no column of signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channels such as marker_V, X3_um</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns named x and y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns named angle and r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns named x and y, or angle and r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a probe record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a profile: x and y, or angle and r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>names, or to be told whether they are x,y or angle,radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a profile as text: x and y, or angle and r</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one unit for all coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x and y, or x, y and z in a coordinate plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle, radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the columns of a profile without names hold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius that the deviations are laid on, when a file holds nothing but deviations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least-squares circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum-zone circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum inscribed circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum circumscribed circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum zone of scattered points, by enumeration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap certified for minimum zone and inscribed circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least-squares cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum-zone cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straightness of an axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a count and as many points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NIST reference circles, least squares</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Transmission of the Gaussian filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a field such as K0001/1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of a characteristic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>characteristics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a value before its attribute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as many characteristics as K0100 says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Q-DAS file with K-fields</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{count} kinds of reference data refitted: all answers agree</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{failed} of {count} kinds of reference data miss their answers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference data refitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NIST reference sets from {path}; the other sets are built in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verification of the installation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each set is fitted anew by this program on this computer. The answers follow from the way the data are made (closed forms), from trying all possible contacts, or are NIST&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{points} points a turn are too few for {cutoff_upr} UPR by the rule of 7 points a wave; they carry {supported_upr} UPR. The answer is given all the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The points leave {missing_deg}° of the turn out: this is the roundness of an arc, and harmonics say little.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The points are unevenly spread over the turn; filter and harmonics take that into account.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another centre gives the same minimum zone: RONt is sure, the centre is not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another centre holds an equal maximum inscribed circle; RONt(MICI) depends on which is taken.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{circle} is proved to {gap_um} µm only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few points to tell their noise from the form; state the uncertainty of a point for an uncertainty of the result.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile holds deviations from a nominal radius: form is measured, size is not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The form does not determine the angle between the profiles; several rotations fit as well.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eccentricity: how the part sat on the measuring axis; no form</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>oval: clamping between two jaws, an oval spindle bearing, or an oval blank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three lobes: the clamping force of a three-jaw chuck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>four lobes: the clamping force of a four-jaw chuck</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>five lobes: centreless ground bar stock, or a five-pad clamping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>six lobes: a six-jaw chuck, or three jaws that press on pairs of spots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>several lobes: spindle bearing, its balls or rollers, or the drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waves: vibration of workpiece or tool at a multiple of the spindle speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>short waves: chatter, or the trace of the tool&apos;s feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UPR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter cut-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian filter: waves up to so many undulations per revolution pass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaussian filter: waves between these undulations per revolution pass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Excluded sectors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyways and interruptions, as angles seen from the centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave out (Hampel)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points that stand out of their neighbours by more than 5 standard deviations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Least squares (LSCI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum zone (MZCI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maximum inscribed (MICI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Minimum circumscribed (MCCI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The circle of the headline and the verdict; all four are reported.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest roundness deviation RONt allowed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One standard deviation; by default found from the profile&apos;s own noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>either a cut-off or a band</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one band such as 15:500</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylindricity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straightness of the axis of the sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius (least squares)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within {tolerance} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>above {tolerance} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? not decided at {tolerance} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ISO 12180: CYLt is the largest minus the smallest distance of the points from the axis of the reference cylinder. The minimum zone is locally optimal, found from several starts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact point, outer circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact point, inner circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 division = {step} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations magnified {times} times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base circle: radius {radius} mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profile and reference circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harmonics of the unfiltered profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undulations per revolution (UPR)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut-off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RONt by method: how much of the value is the method?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outliers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LSCI (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MZCI (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MICI (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MCCI (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undersampled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this result</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strongest harmonics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>amplitude (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phase (°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the form (%)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what it usually is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least squares (LSCI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>minimum zone (MZCI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maximum inscribed (MICI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>minimum circumscribed (MCCI)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roundness deviation by reference circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RONt (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre x (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre y (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inner radius (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outer radius (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>proved to (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the least-squares circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak to reference RONp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference to valley RONv</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square RONq</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expanded uncertainty (k = 2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ISO 14253-1: only what is sure passes or fails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>simple: the value alone is compared</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sizes across the section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-point size, largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-point size, smallest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-point size range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half of it: ovality by GOST 24642</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width between jaws, largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width between jaws, smallest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As in the source paper, about the origin of the coordinates; not roundness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radial run-out about the spindle axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre by the limaçon formula, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre by the limaçon formula, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of a point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>U, k = 2 (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the form consists of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The uncertainty is twice the root mean square by which the noise of the points changes the value, filtered and fitted anew (Monte Carlo). The table shows what other methods would say of the same points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ within tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ out of tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? not decided: too near the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? not decided: {tolerance} µm is within the uncertainty of {uncertainty} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{upr} UPR, {amplitude} µm: {meaning}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ISO 12181: RONt is the largest minus the smallest distance of the profile from the centre of the reference circle. Filter: Gaussian, ISO 16610-21. The minimum zone and the inscribed circle are proved by branch and bound.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The second profile laid on the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Root mean square difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correlation of the forms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shifted by, x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shifted by, y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius larger by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle (°)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest difference {largest} µm · mean {mean} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Superimposed profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fitting cylinders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no filter beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one profile to lay the other on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluating</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluate the points as they are; this is the default.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Superimpose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay the profile of this file on the one given: rotation and centre fitted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Superimpose also the other way round.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The record does not say the workpiece&apos;s diameter. State it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{signal} cannot be channel {found}: {reason}. The record has {channels} channels, counted from 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{signal}: channel {found} ({channel}) states no unit; expected µm, mm or V in its heading, such as X3_um.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel {place} ({channel}) is no marker of revolutions: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel {place} ({channel}) is no marker of revolutions: {reason}. Channel {candidate} ({candidate_channel}) looks like one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channel {place} ({channel}) is no angle of revolution: {reason}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time does not go forward at row {row}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{found} whole revolutions are too few; at least {minimum} are needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{found} revolutions are too few for {sections} sections; at least {minimum} are needed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The records are not of one workpiece: {parameter} is {first} in the first and {found} here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {signal} ({channel}) stands still; is the probe connected?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {signal} ({channel}) rests at the end of its range for {share_percent} % of the time; the probe was out of range.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {signal} reaches {largest_um} µm, more than a probe measures; check the sensitivity and the channels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the delay from channel to channel is not known; taken as none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {found} revolutions in a section instead of {asked}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: the marks come {found_rpm} times a minute, the record says {stated_rpm} rpm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A longitudinal section needs sections at {minimum} different places; there are {found}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The diameter of {diameter_mm} mm is nominal: form is measured, size is referenced to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two probes cannot tell the mandrel&apos;s own form (up to {form_um} µm) from its motion: nothing smaller is resolved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: averages over revolutions; asynchronous motion and single revolutions are not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the workpiece, from the free end (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longitudinal section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter, deviation from its mean (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taper and barrel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roundness of the sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectories over one turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>axis of the workpiece (X3, Y3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool (Xp, Yp)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius about the spindle axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation from the mean radius (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>single revolutions: from the smallest to the largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error motion of the spindle, sensitive direction X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>single revolutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>synchronous (their mean)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Taper on diameter (+ grows from the free end)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Barrel on radius (+ barrel, - saddle)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range of the diameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half of it, as GOST 24642-81 has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straightness of the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straightness of the profile (residual about its line)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylindricity CYLt(LSCY)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cylindricity CYLt(MZCY), locally optimal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The section with the largest deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the free end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radial run-out about the spindle axis (the paper&apos;s; not roundness)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diameter (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>two-point (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run-out (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>revolutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error motion (ISO 230-7), without mean and eccentricity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>synchronous (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asynchronous (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total (µm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drift (µm/rev)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotating direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting data, as the record states them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the workpiece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of spindle and tool in that section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The images of single revolutions have RONt(LSCI) from {least} to {most} µm; their mean hides what differs from turn to turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (section {section} of {count})</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · taper {taper} µm on diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · saddle {size} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · barrel {size} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · within {tolerance} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · above {tolerance} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · not decided: too near to {tolerance} µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectories and the machined surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image of the surface in the section with the largest deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The image of the surface is the path of the tool as seen from the axis of the workpiece: radius |AP| with A = (X3, Y3), P = (D/2 + Xp, Yp), at the angle of the spindle plus atan2(Y3 - Yp, D/2 - X3 + Xp). Diameters are referenced to the nominal one. Roundness by ISO 12181 about the fitted centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>signal=channel, such as X3=1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each signal once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no such channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no channel has this name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds angles, not displacements</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it holds no angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>each channel once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it has hardly any values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it stands still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it does not rest on two levels, as a marker does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a threshold between the levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its pulses follow each other within a few frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its pulses come at irregular times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it makes no whole turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it runs back and forth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its turns follow each other within a few frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the workpiece&apos;s diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one continuous record, and no places of its sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one place for each section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding revolutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaluating sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Workpiece diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nominal; by default as the record says. Form is measured, size is not.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angles of a revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every revolution is sampled anew at so many even angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Revolutions of a section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So many are averaged; fewer when the record is shorter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delay from channel to channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A multiplexed converter samples each channel so much after the one before.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which channel is which signal, counted from 0: marker=0 or angle=0, X3=1, Y3=2, Xp=3, Yp=4; -X3=1 turns a sign.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of displacement channels recorded in volts; others need none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>µm/V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marker threshold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By default half way between the marker&apos;s two levels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opposite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle on the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen from the part, the angle may run against the spindle&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places of the sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cuts one continuous record into sections along the workpiece.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm/rev</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Into how many a continuous record is cut.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slope of a section removed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean of a section stays in any case: it is the size.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left out by Hampel&apos;s rule</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples and revolutions that stand out from the others of their section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outliers from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In robust standard deviations from the median.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>σ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop the record of a whole workpiece here, or one record for each section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longitudinal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface of all sections, deviations magnified</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Proved to [µm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the undulations say</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude [µm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share [%]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Usual cause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a measured profile or a probe record here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe records</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One record of all sections, or one for each: CSV or L-Graph</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x and y, or angle and radius, of one section; goes before the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trace to lay over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same section from a roundness instrument, for the difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe records and profiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laying the trace on the profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laid over each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error motion of all revolutions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>synchronous</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a probe record here: a table, or a pair .dat and .par of L-Graph.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Synchronous error motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asynchronous error motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Total error motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Motion of spindle and tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error motion (ISO 230-7)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? undecided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{label} {value} {unit}: taken from {source}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: rows skipped: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: points without finite coordinates, left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: normals without a direction: {count}; the normals are not used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: time steps that differ from {step_s} s: {count}, the first at line {line}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: missing samples of {channel}: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points further than {distance_mm} mm from the reference, left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points in the excluded zones, left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps in the profile: {count}, the largest of {largest_deg}°. Beside them filter and harmonics rest on the points that are there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points that lie where others do: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outliers left out (Hampel): {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points in the excluded sectors, left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: revolutions of irregular length, left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: revolutions with missing samples, left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: {used} of {found} revolutions were used, as the parameters ask.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left out because they stand out: revolutions {revolutions}, samples {samples}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sections without a known place along the workpiece: {count}. No longitudinal section.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>numbers such as 5,10,15 or 5,5;10;15</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the workpiece from its free end, one for each: 5,10,15 or 5,5;10;15.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section {section} of {count}, {z_mm} mm from the free end; revolutions: {turns}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section {section} of {count}; revolutions: {turns}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile, from {circle} (mean)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>profile, from {circle}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points do not lie in sections across the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are too few sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harmonics above {carried_upr} UPR are left out: the points, up to {spacing_deg}° apart, do not carry them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Harmonics above {determined_upr} UPR are estimates beside the gaps: up to {leakage_percent} % of one may stand in another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The values change in steps of {resolution_um} µm; the uncertainty counts them as step/√12.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The noise of neighbours moves together over about {points} points. Assumed: what no harmonic explains is noise; the uncertainty allows for it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single points that stand out of the profile: {count}, by up to {largest_um} µm. They count in RONt and in its uncertainty; the outlier rule would leave them out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No two-point size in {share_percent} % of the directions: a gap lies opposite.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The trace is {eccentricity_um} µm off centre: RONt depends on the radius of {radius_mm} mm it is laid on, by up to {effect_um} µm, which the uncertainty counts. Centre the part better, or state its radius.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No straightness of the axis: {reason}. Sections found: {sections}, needed: {minimum}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>circles as .ds (a count and points) and .fit (7 numbers)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points out of the plane of a circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a direction across no coordinate plane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a file in place of a folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no file in .ds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the source text of a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Q-DAS file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a JSON text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a PLY scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a PCD scan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an STL mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an OBJ mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an IGES file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a DXF drawing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a universal file (UFF)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>an NC program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a text document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing but zero bytes to the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the source text of a program or JSON</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{parameter} would overwrite {file}, which is an input. Name another file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{parameter}: {file} is named for two outputs, also as {other}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Several columns may be meant: found “{found}”, where {candidates} could each be {meaning}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This folder holds no reference data: found {found}, expected {expected}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: columns read: {columns}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x or y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the angle or the radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>further bytes behind the last element</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · form not measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sets are built in; no folder with further ones was named.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sections span {length_mm} mm of a workpiece of {diameter_mm} mm: too short for an axis, so there is no cylindricity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sections whose form is not measured: {count}. In section {section} RONt is {RONt_um} µm with an uncertainty of {expanded_uncertainty_um} µm: noise, drift or hum, not form. They are not judged.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the name of a file; only --json writes to standard output</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder with NIST&apos;s circle sets (.ds, .fit), refitted beside the built-in ones.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path}: facets with two corners in one place, left out: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points further from the reference are left out; by default 0.6 % of its size or 10 standard deviations.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {role} shows {coverage_deg}° of the circle; at least {minimum_deg}° are needed for an axis.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Facets of the reference that run round the other way than their neighbours, turned: {count}.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Small holes of the reference&apos;s mesh, filled: {count}, up to {largest_mm} mm wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mesh of the {role} is coarse: its facets lie up to {sagitta_mm} mm inside the round surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {role} shows {coverage_deg}° of the circle, less than half: out-of-roundness passes for a shift.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {role} is bent: its centre line bows by {bow_mm} ± {bow_uncertainty_mm} mm. The axis runs straight through the section centres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there are several parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no single axis fits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is bent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too little of the circle is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the points lie on a line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its sections are not round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The {role} is not a body of revolution: {why} (residual {residual_mm} mm).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The points go round {revolutions} times: the revolutions lie over each other and were evaluated as one profile, their differences as noise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has {found_MiB} MiB; the memory that is free allows for {maximum_MiB} MiB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program changed the file while it was read. Read it again when it is complete.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fewer members</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a shorter list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fewer ranges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer: {input} is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer: {reason}</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer: the computation was stopped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe record or profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file is no longer the one that was read: SHA-256 was {read}…, is {now}…. Compute again (F5) to take the new file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} was changed after it was read: SHA-256 was {read}…, is {now}…. This answer is of the file as it was; compute again (F5) to take the new one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>{path} is no longer there. This answer is of the file as it was, SHA-256 {read}….</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::AngleBar</name>
    <message>
        <source>Play: run around the part by angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marked angle on the part</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::ChannelTable</name>
    <message>
        <source>not stated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>revolution marker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle of an encoder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (workpiece axis)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (tool)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels of the record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signal of channel %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::CompareCharts</name>
    <message>
        <source>Along the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meridian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>error drawn × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribution of the deviations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unrolled surface, local means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>excess</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>± %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too small</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too large</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::ComparePanel</name>
    <message>
        <source>Change the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swap reference and copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations of all points (PLY)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point cloud (*.ply)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviations of all points (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>⇅ Swap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference and copy change places</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::CompareViews</name>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the axis %1 mm, angle %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deviation %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this point was left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean around it %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3-D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meridian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The original blue, the copy red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The copy, coloured by its distance from the original&apos;s surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Local mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each point has the mean of its surroundings, as in the map; off: every point by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many times larger the meridian draws the deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These scans were computed, not measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation [mm]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::CopyTable</name>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
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
    <name>lathelier::HelpWindow</name>
    <message>
        <source>Lathelier help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare a copy with its original</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop two scans on the window – the original (reference) and the copy – or open them at the left. Point clouds and meshes are read: XYZ, ASC, CSV, TXT, PTS, PLY, PCD, STL, OBJ. The answer stands in large type above the views, with its notes under it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A positive deviation is material in excess, a negative one is missing material. State a tolerance at the left to get a verdict. Whatever you change is computed again at once; Undo takes back any step.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>When a file is refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The message names the file, the line and column or byte, and what was expected. If the file leaves its unit or its decimal mark open, state it under the file&apos;s name at the left; the project remembers it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“Report…” writes the result on screen as HTML or PDF, with method, parameters, notes and the digests of the input files. “In the report” makes it part of the project&apos;s report (File menu).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>open a project or measured files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>save the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undo, redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compute again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stop the computation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>presenter mode: larger type, thicker lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all commands, found by typing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Lathelier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A desktop workbench for turning shops: scan, predict, cut without chatter, measure, prove.

Free software under the GNU General Public License, version 3 or later. It works offline; your files stay with you.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure roundness and the spindle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In workspace Roundness, drop a probe record (CSV, or a pair .dat and .par of L-Graph) or a measured profile. Three panels look at the same data: Roundness shows one section with its four reference circles, Trajectory how axis and tool move, Longitudinal the whole workpiece. Section, circle and filter are chosen once for all of them. The worst section is shown first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::InputBox</name>
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
    <message>
        <source>binary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows skipped: %L1</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lathelier::InputColumn</name>
    <message>
        <source>Change: %1</source>
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
        <source>Open: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2);;All files (*)</source>
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
    <name>lathelier::LimitEdit</name>
    <message>
        <source>The colour scale runs from minus to plus this many mm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Limit of the colour scale in mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::LongitudinalCharts</name>
    <message>
        <source>Longitudinal profile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the workpiece, z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius − mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taper %1 µm on diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>barrel %1 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saddle %1 µm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::LongitudinalPanel</name>
    <message>
        <source>Table of all sections (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All numbers (JSON)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For statistical process control (Q-DAS)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-DAS (*.dfq)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::LongitudinalViews</name>
    <message>
        <source>deviation × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface of all sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section %1, angle %2°
deviation %3 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>form of each section only</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take out where each section lies and how large it is: what is left is its roundness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many times larger the surface draws the deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deviation [µm]</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::MainWindow</name>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unnamed project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the sa&amp;mple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project report as &amp;HTML…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Project report as &amp;PDF…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compute again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop the computation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Presenter mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All &amp;commands…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Lathelier</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Workspaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Workspaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing what belongs in the report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Verify installation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project or measured files</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::MapView</name>
    <message>
        <source>no data</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::MessageLog</name>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the selected messages, or all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear the log</source>
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
    <message>
        <source>Usual values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::PanelBase</name>
    <message>
        <source>Open %1</source>
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
        <source>%L1 triangles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 points</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::PlotWidget</name>
    <message>
        <source>Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save data as CSV…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scalable picture (*.svg);;PDF (*.pdf);;Picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::PolarView</name>
    <message>
        <source>Take the mark away</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::PolarWords</name>
    <message>
        <source>outer contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inner contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 µm/div</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deviation × %1 · %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, inner circle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, outer circle</source>
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
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HTML report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a report of this result</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::ProjectFiles</name>
    <message>
        <source>Lathelier projects (*.lathelier)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save them before going on?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a project without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lathelier ended unexpectedly. Unsaved work on %1 was kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recover</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the sample scans…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was changed by another window or program since it was opened here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Both versions stay when yours gets another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save under another name…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::RoundnessCharts</name>
    <message>
        <source>Spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before the filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undulations per revolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 UPR</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::RoundnessPanel</name>
    <message>
        <source>Profile and circles as drawn (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All numbers (JSON)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For statistical process control (Q-DAS)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Q-DAS (*.dfq)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::RoundnessViews</name>
    <message>
        <source>largest difference %1 µm, mean %2 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roundness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile with its reference circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laid over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The profile and the trace over each other, and their difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undulations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::SceneBar</name>
    <message>
        <source>Oblique</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel projection: equal lengths look equal at any distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut along X</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut along Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut along Z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut away one side of the part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::SceneRuler</name>
    <message>
        <source>Directions and length scale</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::SceneView</name>
    <message>
        <source>The 3-D view needs OpenGL, which is not available here.
All other views work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::SectionBar</name>
    <message>
        <source>Section %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> · z %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The section before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The section that all panels of this workspace show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>worst</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always the section with the largest roundness deviation</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::SectionTable</name>
    <message>
        <source>All sections against the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre x [µm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre y [µm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run-out [µm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest minus smallest radius about the spindle axis: the paper&apos;s value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Referenced to the nominal diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✗ out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>? not decided</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-point [µm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two-point range: largest minus smallest distance of opposite points; half of it: GOST</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How often unsaved work is kept aside, in case the program ends unexpectedly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type size in presenter mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Autosave every</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presenter type size</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::SpindlePanel</name>
    <message>
        <source>%L1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>averages of %L1 sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%L1 frames</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose section %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the worst section</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::StatisticsTable</name>
    <message>
        <source>Statistics</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::TrajectoryCharts</name>
    <message>
        <source>Trajectories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>workpiece axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates over the angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle as recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 revolution marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>marks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R − mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>synchronous %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>asynchronous %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>total %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::TrajectoryPanel</name>
    <message>
        <source>Change the channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectories and images of all sections (CSV)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All numbers (JSON)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spindle X3: %1 · %2 turns</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::TrajectoryViews</name>
    <message>
        <source>ISO 230-7, fixed sensitive direction, %1 revolutions: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first of %1 records:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorder: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 frames a second, %2 s, %3 channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Averages over the revolutions: %1 sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file says: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Workpiece axis (blue) and tool (orange) of all sections along z; displacements × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all sections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw the trajectories of all sections behind the chosen one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The probe whose error motion is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Trajectories</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Signals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All sections in 3-D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record and channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>section %1, angle %2°</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::VerifyDialog</name>
    <message>
        <source>Write the report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verify installation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles, cylinders, lines, filters and harmonics with known answers are computed on this computer. The largest deviation of each kind has to stay below its limit.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kinds of reference data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::XyView</name>
    <message>
        <source>radius vector %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>lathelier::ZoneTable</name>
    <message>
        <source>Zones along the axis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scatter [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of the single points in the zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▲ above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>▼ below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>✓ within</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
