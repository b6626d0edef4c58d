<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="pl" sourcelanguage="en">
<context>
    <name>Engine</name>
    <message>
        <source>The option {option} is not known.</source>
        <translation>Opcja {option} nie jest znana.</translation>
    </message>
    <message>
        <source>{parameter} is {found}; expected {expected} from {minimum} to {maximum}.</source>
        <translation>{parameter} ma wartość {found}; oczekiwano: {expected} od {minimum} do {maximum}.</translation>
    </message>
    <message>
        <source>{parameter}: found “{found}”, expected {expected}.</source>
        <translation>{parameter}: jest „{found}”, oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>This file does not exist.</source>
        <translation>Ten plik nie istnieje.</translation>
    </message>
    <message>
        <source>The file cannot be read: {reason}.</source>
        <translation>Nie można odczytać pliku: {reason}.</translation>
    </message>
    <message>
        <source>Expected a file, found {found}.</source>
        <translation>Oczekiwano pliku, a jest {found}.</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>Plik jest pusty.</translation>
    </message>
    <message>
        <source>The file cannot be written: {reason}.</source>
        <translation>Nie można zapisać pliku: {reason}.</translation>
    </message>
    <message>
        <source>Found “{found}”, expected {expected}.</source>
        <translation>Jest „{found}”, oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The file ends early: {found} of {expected} {items} are there.</source>
        <translation>Plik urywa się przedwcześnie: jest {found} z {expected} ({items}).</translation>
    </message>
    <message>
        <source>“{found}” can be read in two ways: {first} or {second}. State the decimal mark.</source>
        <translation>„{found}” można odczytać na dwa sposoby: {first} albo {second}. Podaj znak dziesiętny.</translation>
    </message>
    <message>
        <source>The file states no unit, and an extent of {extent} fits no guess. State the unit.</source>
        <translation>Plik nie podaje jednostki, a rozmiar {extent} nie pozwala jej odgadnąć. Podaj jednostkę.</translation>
    </message>
    <message>
        <source>The file holds no usable point.</source>
        <translation>Plik nie zawiera ani jednego przydatnego punktu.</translation>
    </message>
    <message>
        <source>The coordinate {found} is out of reach; expected at most {maximum}.</source>
        <translation>Współrzędna {found} jest poza zakresem; oczekiwano najwyżej {maximum}.</translation>
    </message>
    <message>
        <source>{found} points are too few; at least {minimum} are needed.</source>
        <translation>Za mało punktów: {found}; potrzeba co najmniej {minimum}.</translation>
    </message>
    <message>
        <source>The points all lie {found}; no answer follows from that.</source>
        <translation>Wszystkie punkty leżą {found}; nie wynika z tego żadna odpowiedź.</translation>
    </message>
    <message>
        <source>The two parts do not match: only {overlap_percent} % of the copy lies near the reference.</source>
        <translation>Części nie pasują do siebie: tylko {overlap_percent} % kopii leży blisko oryginału.</translation>
    </message>
    <message>
        <source>No stable solution after {iterations} iterations.</source>
        <translation>Brak stabilnego rozwiązania po {iterations} iteracjach.</translation>
    </message>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Za mało pamięci.</translation>
    </message>
    <message>
        <source>Lathelier made a mistake here ({reason}). Please report it.</source>
        <translation>Lathelier popełnił tu błąd ({reason}). Prosimy o zgłoszenie.</translation>
    </message>
    <message>
        <source>The project has format version {found}; this program reads up to version {maximum}.</source>
        <translation>Projekt ma format w wersji {found}; ten program czyta wersje do {maximum}.</translation>
    </message>
    <message>
        <source>{path}: no unit is stated; read as {unit} because of its extent of {extent}.</source>
        <translation>{path}: brak jednostki; przyjęto {unit} na podstawie rozmiaru {extent}.</translation>
    </message>
    <message>
        <source>Roll about the axis is not determined by the geometry; the smallest rotation was kept.</source>
        <translation>Geometria nie wyznacza obrotu wokół osi; zachowano najmniejszy obrót.</translation>
    </message>
    <message>
        <source>A {kind} is not determined by the geometry; the initial pose was kept along it.</source>
        <translation>Geometria nie wyznacza tego ruchu: {kind}; zachowano w nim położenie początkowe.</translation>
    </message>
    <message>
        <source>A {kind} is only weakly determined by the geometry.</source>
        <translation>Geometria słabo wyznacza ten ruch: {kind}.</translation>
    </message>
    <message>
        <source>Method chosen: {method} ({reason}).</source>
        <translation>Wybrana metoda: {method} ({reason}).</translation>
    </message>
    <message>
        <source>The copy was turned end for end.</source>
        <translation>Kopię odwrócono końcami.</translation>
    </message>
    <message>
        <source>Inside and outside are not known (no normals, no closed surface): the deviation has no sign.</source>
        <translation>Nie wiadomo, gdzie jest wnętrze (brak normalnych i zamkniętej powierzchni): odchyłka nie ma znaku.</translation>
    </message>
    <message>
        <source>The difference cannot be told from the scanner&apos;s accuracy of {scanner_accuracy_mm} mm.</source>
        <translation>Różnicy nie da się odróżnić od dokładności skanera {scanner_accuracy_mm} mm.</translation>
    </message>
    <message>
        <source>{path} has changed since the project was saved.</source>
        <translation>{path} zmienił się od zapisania projektu.</translation>
    </message>
    <message>
        <source>{path} is missing.</source>
        <translation>Brak pliku {path}.</translation>
    </message>
    <message>
        <source>yes or no</source>
        <translation>tak albo nie</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>liczba całkowita</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>liczba</translation>
    </message>
    <message>
        <source>one of the choices</source>
        <translation>jedna z możliwości</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>tekst</translation>
    </message>
    <message>
        <source>ranges such as 10:20,35:40</source>
        <translation>przedziały, np. 10:20,35:40</translation>
    </message>
    <message>
        <source>line {line}</source>
        <translation>wiersz {line}</translation>
    </message>
    <message>
        <source>column {column}</source>
        <translation>kolumna {column}</translation>
    </message>
    <message>
        <source>byte {byte}</source>
        <translation>bajt {byte}</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>tak</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>a folder</source>
        <translation>folder</translation>
    </message>
    <message>
        <source>a socket</source>
        <translation>gniazdo</translation>
    </message>
    <message>
        <source>a device</source>
        <translation>urządzenie</translation>
    </message>
    <message>
        <source>the pipe delivers more than 4 GiB</source>
        <translation>potok dostarcza ponad 4 GiB</translation>
    </message>
    <message>
        <source>nobody writes into this pipe</source>
        <translation>nikt nie pisze do tego potoku</translation>
    </message>
    <message>
        <source>no permission</source>
        <translation>brak uprawnień</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>dysk jest pełny</translation>
    </message>
    <message>
        <source>the disk quota is used up</source>
        <translation>wyczerpano przydział dysku</translation>
    </message>
    <message>
        <source>the file would be too large</source>
        <translation>plik byłby za duży</translation>
    </message>
    <message>
        <source>the disk is read-only</source>
        <translation>dysk jest tylko do odczytu</translation>
    </message>
    <message>
        <source>it is a folder</source>
        <translation>to jest folder</translation>
    </message>
    <message>
        <source>the folder does not exist</source>
        <translation>folder nie istnieje</translation>
    </message>
    <message>
        <source>the name is too long</source>
        <translation>nazwa jest za długa</translation>
    </message>
    <message>
        <source>its links go round in a circle</source>
        <translation>dowiązania tworzą pętlę</translation>
    </message>
    <message>
        <source>too many files are open</source>
        <translation>otwarto zbyt wiele plików</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>za mało pamięci</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>Odczyt</translation>
    </message>
    <message>
        <source>Saved {path}.</source>
        <translation>Zapisano {path}.</translation>
    </message>
    <message>
        <source>The kind of this file is not known: found {found}, expected {expected}.</source>
        <translation>Nieznany rodzaj pliku: jest {found}, oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>{path}: {announced} rows are announced, {found} are there; all were read.</source>
        <translation>{path}: liczba wierszy zapowiedzianych: {announced}, obecnych: {found}; odczytano wszystkie.</translation>
    </message>
    <message>
        <source>{path}: the file states {unit}; the given unit {given} is not used.</source>
        <translation>{path}: plik podaje jednostkę {unit}; wskazanej jednostki {given} nie użyto.</translation>
    </message>
    <message>
        <source>a byte that is no UTF-8</source>
        <translation>bajt niezgodny z UTF-8</translation>
    </message>
    <message>
        <source>text in UTF-8</source>
        <translation>tekst w UTF-8</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatycznie</translation>
    </message>
    <message>
        <source>point</source>
        <translation>kropka</translation>
    </message>
    <message>
        <source>comma</source>
        <translation>przecinek</translation>
    </message>
    <message>
        <source>Decimal mark</source>
        <translation>Znak dziesiętny</translation>
    </message>
    <message>
        <source>How text files write decimals; automatic asks when 1,234 could be a thousand.</source>
        <translation>Jak pliki tekstowe zapisują ułamki; tryb automatyczny pyta, gdy 1,234 może oznaczać tysiąc.</translation>
    </message>
    <message>
        <source>blank</source>
        <translation>odstęp</translation>
    </message>
    <message>
        <source>semicolon</source>
        <translation>średnik</translation>
    </message>
    <message>
        <source>tabulator</source>
        <translation>tabulator</translation>
    </message>
    <message>
        <source>vertical bar</source>
        <translation>kreska pionowa</translation>
    </message>
    <message>
        <source>Separator</source>
        <translation>Separator</translation>
    </message>
    <message>
        <source>What stands between the columns of a text file.</source>
        <translation>Co rozdziela kolumny pliku tekstowego.</translation>
    </message>
    <message>
        <source>Encoding</source>
        <translation>Kodowanie</translation>
    </message>
    <message>
        <source>How a text file stores its characters.</source>
        <translation>Jak plik tekstowy zapisuje znaki.</translation>
    </message>
    <message>
        <source>Unit of length</source>
        <translation>Jednostka długości</translation>
    </message>
    <message>
        <source>Unit of a file that states none. A stated unit always rules.</source>
        <translation>Jednostka pliku, który jej nie podaje. Jednostka podana w pliku ma zawsze pierwszeństwo.</translation>
    </message>
    <message>
        <source>the index of a vertex</source>
        <translation>numer wierzchołka</translation>
    </message>
    <message>
        <source>an OBJ keyword such as v or f</source>
        <translation>słowo kluczowe OBJ, np. v lub f</translation>
    </message>
    <message>
        <source>remark</source>
        <translation>uwaga</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>koniec wiersza</translation>
    </message>
    <message>
        <source>three corners or more</source>
        <translation>co najmniej trzy wierzchołki</translation>
    </message>
    <message>
        <source>a count</source>
        <translation>liczebność</translation>
    </message>
    <message>
        <source>one value for each of the FIELDS</source>
        <translation>po jednej wartości na każde z pól FIELDS</translation>
    </message>
    <message>
        <source>ascii, binary or binary_compressed</source>
        <translation>ascii, binary albo binary_compressed</translation>
    </message>
    <message>
        <source>points of at most 1 MiB</source>
        <translation>punkty o wielkości najwyżej 1 MiB</translation>
    </message>
    <message>
        <source>FIELDS with x, y and z before this line</source>
        <translation>FIELDS z x, y i z przed tym wierszem</translation>
    </message>
    <message>
        <source>POINTS or WIDTH and HEIGHT before this line</source>
        <translation>POINTS albo WIDTH i HEIGHT przed tym wierszem</translation>
    </message>
    <message>
        <source>1, 2, 4 or 8</source>
        <translation>1, 2, 4 albo 8</translation>
    </message>
    <message>
        <source>F, I or U</source>
        <translation>F, I albo U</translation>
    </message>
    <message>
        <source>a line of a PCD header</source>
        <translation>wiersz nagłówka PCD</translation>
    </message>
    <message>
        <source>a line DATA</source>
        <translation>wiersz DATA</translation>
    </message>
    <message>
        <source>real numbers of 4 or 8 bytes</source>
        <translation>liczby rzeczywiste 4- lub 8-bajtowe</translation>
    </message>
    <message>
        <source>points</source>
        <translation>punkty</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>bajty</translation>
    </message>
    <message>
        <source>damaged compressed data</source>
        <translation>uszkodzone dane skompresowane</translation>
    </message>
    <message>
        <source>data in LZF compression</source>
        <translation>dane w kompresji LZF</translation>
    </message>
    <message>
        <source>a PLY type such as float or uchar</source>
        <translation>typ PLY, np. float lub uchar</translation>
    </message>
    <message>
        <source>ascii, binary_little_endian or binary_big_endian</source>
        <translation>ascii, binary_little_endian albo binary_big_endian</translation>
    </message>
    <message>
        <source>the number of elements</source>
        <translation>liczba elementów</translation>
    </message>
    <message>
        <source>a whole-number PLY type</source>
        <translation>całkowity typ PLY</translation>
    </message>
    <message>
        <source>the name of the property</source>
        <translation>nazwa właściwości</translation>
    </message>
    <message>
        <source>a line that states the format</source>
        <translation>wiersz podający format</translation>
    </message>
    <message>
        <source>a line of a PLY header</source>
        <translation>wiersz nagłówka PLY</translation>
    </message>
    <message>
        <source>end_header</source>
        <translation>end_header</translation>
    </message>
    <message>
        <source>vertices with the properties x, y and z</source>
        <translation>wierzchołki z właściwościami x, y i z</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>wierzchołki</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>ściany</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>elementy</translation>
    </message>
    <message>
        <source>the length of a list</source>
        <translation>długość listy</translation>
    </message>
    <message>
        <source>an element vertex</source>
        <translation>element vertex</translation>
    </message>
    <message>
        <source>not a finite number</source>
        <translation>to nie jest liczba skończona</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>obraz PNG</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>obraz JPEG</translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation>obraz GIF</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>dokument PDF</translation>
    </message>
    <message>
        <source>a ZIP archive or an Office document</source>
        <translation>archiwum ZIP lub dokument pakietu Office</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>archiwum gzip</translation>
    </message>
    <message>
        <source>a 7z archive</source>
        <translation>archiwum 7z</translation>
    </message>
    <message>
        <source>a zstd archive</source>
        <translation>archiwum zstd</translation>
    </message>
    <message>
        <source>an xz archive</source>
        <translation>archiwum xz</translation>
    </message>
    <message>
        <source>an E57 scan</source>
        <translation>skan E57</translation>
    </message>
    <message>
        <source>a LAS scan</source>
        <translation>skan LAS</translation>
    </message>
    <message>
        <source>a STEP file</source>
        <translation>plik STEP</translation>
    </message>
    <message>
        <source>a VTK file</source>
        <translation>plik VTK</translation>
    </message>
    <message>
        <source>an OFF mesh</source>
        <translation>siatka OFF</translation>
    </message>
    <message>
        <source>an RTF document</source>
        <translation>dokument RTF</translation>
    </message>
    <message>
        <source>an XML document</source>
        <translation>dokument XML</translation>
    </message>
    <message>
        <source>an HTML document</source>
        <translation>dokument HTML</translation>
    </message>
    <message>
        <source>a program</source>
        <translation>program</translation>
    </message>
    <message>
        <source>a database</source>
        <translation>baza danych</translation>
    </message>
    <message>
        <source>points as text, PLY, PCD, STL or OBJ</source>
        <translation>punkty w pliku tekstowym, PLY, PCD, STL albo OBJ</translation>
    </message>
    <message>
        <source>binary data</source>
        <translation>dane binarne</translation>
    </message>
    <message>
        <source>facet or endsolid</source>
        <translation>facet albo endsolid</translation>
    </message>
    <message>
        <source>solid</source>
        <translation>solid</translation>
    </message>
    <message>
        <source>endsolid</source>
        <translation>endsolid</translation>
    </message>
    <message>
        <source>outer loop</source>
        <translation>outer loop</translation>
    </message>
    <message>
        <source>vertex</source>
        <translation>vertex</translation>
    </message>
    <message>
        <source>endloop</source>
        <translation>endloop</translation>
    </message>
    <message>
        <source>endfacet</source>
        <translation>endfacet</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>trójkąty</translation>
    </message>
    <message>
        <source>column names</source>
        <translation>nazwy kolumn</translation>
    </message>
    <message>
        <source>text without rows of numbers</source>
        <translation>tekst bez wierszy liczb</translation>
    </message>
    <message>
        <source>rows of numbers</source>
        <translation>wiersze liczb</translation>
    </message>
    <message>
        <source>a number with a decimal comma</source>
        <translation>liczba z przecinkiem dziesiętnym</translation>
    </message>
    <message>
        <source>a number with a decimal point</source>
        <translation>liczba z kropką dziesiętną</translation>
    </message>
    <message>
        <source>blank line</source>
        <translation>pusty wiersz</translation>
    </message>
    <message>
        <source>number of rows</source>
        <translation>liczba wierszy</translation>
    </message>
    <message>
        <source>heading</source>
        <translation>nagłówek</translation>
    </message>
    <message>
        <source>fewer columns</source>
        <translation>mniej kolumn</translation>
    </message>
    <message>
        <source>more columns of numbers</source>
        <translation>więcej kolumn liczb</translation>
    </message>
    <message>
        <source>text below the rows</source>
        <translation>tekst pod wierszami</translation>
    </message>
    <message>
        <source>a row of numbers</source>
        <translation>wiersz liczb</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>wiersze</translation>
    </message>
    <message>
        <source>a line of at most 1 MiB</source>
        <translation>wiersz o długości najwyżej 1 MiB</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>koniec pliku</translation>
    </message>
    <message>
        <source>columns named x, y and z</source>
        <translation>kolumny o nazwach x, y i z</translation>
    </message>
    <message>
        <source>one unit for x, y and z</source>
        <translation>jedna jednostka dla x, y i z</translation>
    </message>
    <message>
        <source>at most 10000 names in an object</source>
        <translation>najwyżej 10000 nazw w obiekcie</translation>
    </message>
    <message>
        <source>at most 32 levels of nesting</source>
        <translation>najwyżej 32 poziomy zagnieżdżenia</translation>
    </message>
    <message>
        <source>JSON</source>
        <translation>JSON</translation>
    </message>
    <message>
        <source>more</source>
        <translation>więcej</translation>
    </message>
    <message>
        <source>a project of at most 64 MB</source>
        <translation>projekt o wielkości najwyżej 64 MB</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true albo false</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>obiekt</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>lista</translation>
    </message>
    <message>
        <source>a Lathelier project</source>
        <translation>projekt Lathelier</translation>
    </message>
    <message>
        <source>a format version from 1</source>
        <translation>wersja formatu od 1</translation>
    </message>
    <message>
        <source>Scanning the original</source>
        <translation>Skanowanie oryginału</translation>
    </message>
    <message>
        <source>Scanning the copy</source>
        <translation>Skanowanie kopii</translation>
    </message>
    <message>
        <source>in one place</source>
        <translation>w jednym miejscu</translation>
    </message>
    <message>
        <source>on a line</source>
        <translation>na prostej</translation>
    </message>
    <message>
        <source>in a plane</source>
        <translation>na płaszczyźnie</translation>
    </message>
    <message>
        <source>Distances from cloud to cloud</source>
        <translation>Odległości między chmurami</translation>
    </message>
    <message>
        <source>Axis of the reference</source>
        <translation>Oś oryginału</translation>
    </message>
    <message>
        <source>Axis of the copy</source>
        <translation>Oś kopii</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Odchyłki</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatycznie</translation>
    </message>
    <message>
        <source>Body of revolution</source>
        <translation>Bryła obrotowa</translation>
    </message>
    <message>
        <source>Point to plane</source>
        <translation>Punkt do płaszczyzny</translation>
    </message>
    <message>
        <source>Point to point</source>
        <translation>Punkt do punktu</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Metoda</translation>
    </message>
    <message>
        <source>How the copy is aligned; automatic takes the axis of a body of revolution.</source>
        <translation>Jak dopasować kopię; tryb automatyczny używa osi bryły obrotowej.</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Brak</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>Symetria</translation>
    </message>
    <message>
        <source>Whether the part is a body of revolution.</source>
        <translation>Czy część jest bryłą obrotową.</translation>
    </message>
    <message>
        <source>As scanned</source>
        <translation>Jak zeskanowano</translation>
    </message>
    <message>
        <source>Initial pose</source>
        <translation>Położenie początkowe</translation>
    </message>
    <message>
        <source>Automatic finds any pose; as scanned searches near the given one only.</source>
        <translation>Tryb automatyczny znajduje dowolne położenie; „jak zeskanowano” szuka tylko w pobliżu podanego.</translation>
    </message>
    <message>
        <source>Tolerance ±</source>
        <translation>Tolerancja ±</translation>
    </message>
    <message>
        <source>Largest deviation allowed to either side.</source>
        <translation>Największa dopuszczalna odchyłka w każdą stronę.</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Pass from</source>
        <translation>Zgodność od</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Scanner accuracy</source>
        <translation>Dokładność skanera</translation>
    </message>
    <message>
        <source>One standard deviation of the scanner.</source>
        <translation>Jedno odchylenie standardowe skanera.</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Największa odległość</translation>
    </message>
    <message>
        <source>Excluded zones</source>
        <translation>Strefy wyłączone</translation>
    </message>
    <message>
        <source>Clamping areas along the axis, counted from the reference&apos;s first data.</source>
        <translation>Miejsca zamocowania wzdłuż osi, liczone od początku danych oryginału.</translation>
    </message>
    <message>
        <source>translation along the axis</source>
        <translation>przesunięcie wzdłuż osi</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>tolerancja</translation>
    </message>
    <message>
        <source>Deviation along the axis</source>
        <translation>Odchyłka wzdłuż osi</translation>
    </message>
    <message>
        <source>± one standard deviation</source>
        <translation>± jedno odchylenie standardowe</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>średnia</translation>
    </message>
    <message>
        <source>Meridian</source>
        <translation>Zarys osiowy</translation>
    </message>
    <message>
        <source>original</source>
        <translation>oryginał</translation>
    </message>
    <message>
        <source>Histogram of the deviations</source>
        <translation>Histogram odchyłek</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>Punkty</translation>
    </message>
    <message>
        <source>µm</source>
        <translation>µm</translation>
    </message>
    <message>
        <source>body of revolution</source>
        <translation>bryła obrotowa</translation>
    </message>
    <message>
        <source>point to plane</source>
        <translation>punkt do płaszczyzny</translation>
    </message>
    <message>
        <source>point to point</source>
        <translation>punkt do punktu</translation>
    </message>
    <message>
        <source>Deviation of the copy from the original&apos;s surface</source>
        <translation>Odchyłka kopii od powierzchni oryginału</translation>
    </message>
    <message>
        <source>Root mean square</source>
        <translation>Średnia kwadratowa (RMS)</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Średnia</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Odchylenie standardowe</translation>
    </message>
    <message>
        <source>Robust standard deviation (MAD)</source>
        <translation>Odporne odchylenie standardowe (MAD)</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Mediana</translation>
    </message>
    <message>
        <source>Smallest</source>
        <translation>Najmniejsza</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Największa</translation>
    </message>
    <message>
        <source>95 % of the points lie between</source>
        <translation>95 % punktów leży między</translation>
    </message>
    <message>
        <source>… and</source>
        <translation>… a</translation>
    </message>
    <message>
        <source>95 % of the sizes lie below</source>
        <translation>95 % wartości bezwzględnych leży poniżej</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Tolerance, plus and minus</source>
        <translation>Tolerancja, w plus i w minus</translation>
    </message>
    <message>
        <source>Share within tolerance</source>
        <translation>Udział w tolerancji</translation>
    </message>
    <message>
        <source>Share needed to pass</source>
        <translation>Udział wymagany</translation>
    </message>
    <message>
        <source>none: no tolerance was given</source>
        <translation>brak: nie podano tolerancji</translation>
    </message>
    <message>
        <source>Scanner&apos;s accuracy</source>
        <translation>Dokładność skanera</translation>
    </message>
    <message>
        <source>Difference told from the scanner&apos;s accuracy</source>
        <translation>Różnica odróżnialna od dokładności skanera</translation>
    </message>
    <message>
        <source>Overlap (points of the copy that were used)</source>
        <translation>Pokrycie (użyte punkty kopii)</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>Punkty użyte</translation>
    </message>
    <message>
        <source>Points left out</source>
        <translation>Punkty pominięte</translation>
    </message>
    <message>
        <source>Zones along the axis</source>
        <translation>Strefy wzdłuż osi</translation>
    </message>
    <message>
        <source>Alignment</source>
        <translation>Dopasowanie</translation>
    </message>
    <message>
        <source>Converged</source>
        <translation>Zbieżne</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteracje</translation>
    </message>
    <message>
        <source>Uncertainty along the axis (k = 2)</source>
        <translation>Niepewność wzdłuż osi (k = 2)</translation>
    </message>
    <message>
        <source>Uncertainty, largest direction (k = 2)</source>
        <translation>Niepewność w kierunku największej (k = 2)</translation>
    </message>
    <message>
        <source>Uncertainty across the axis (k = 2)</source>
        <translation>Niepewność w poprzek osi (k = 2)</translation>
    </message>
    <message>
        <source>Uncertainty across it (k = 2)</source>
        <translation>Niepewność w poprzek niego (k = 2)</translation>
    </message>
    <message>
        <source>Uncertainty of the axis&apos;s direction (k = 2)</source>
        <translation>Niepewność kierunku osi (k = 2)</translation>
    </message>
    <message>
        <source>Uncertainty of the rotation (k = 2)</source>
        <translation>Niepewność obrotu (k = 2)</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Nearest-point figure, as in the source paper</source>
        <translation>Wynik najbliższego punktu, jak w artykule źródłowym</translation>
    </message>
    <message>
        <source>Cloud-to-cloud RMSE</source>
        <translation>RMSE chmura–chmura</translation>
    </message>
    <message>
        <source>Its floor: what sampling alone gives</source>
        <translation>Jego dolna granica: samo próbkowanie</translation>
    </message>
    <message>
        <source>Motions the geometry does not determine</source>
        <translation>Ruchy, których geometria nie wyznacza</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>ruch</translation>
    </message>
    <message>
        <source>direction x</source>
        <translation>kierunek x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>obrót</translation>
    </message>
    <message>
        <source>translation</source>
        <translation>przesunięcie</translation>
    </message>
    <message>
        <source>From the copy&apos;s coordinates to the original&apos;s</source>
        <translation>Ze współrzędnych kopii do współrzędnych oryginału</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parametry</translation>
    </message>
    <message>
        <source>Deviations are measured along the normal of the original&apos;s surface; plus means material in excess.</source>
        <translation>Odchyłki mierzy się wzdłuż normalnej do powierzchni oryginału; plus oznacza naddatek materiału.</translation>
    </message>
    <message>
        <source>Deviations are distances from the original&apos;s surface, without a sign.</source>
        <translation>Odchyłki są odległościami od powierzchni oryginału, bez znaku.</translation>
    </message>
    <message>
        <source>The cloud-to-cloud figure mixes the difference of the parts with the distance between neighbouring points: even identical parts reach its floor. The deviation from the surface does not depend on it.</source>
        <translation>Wynik chmura–chmura miesza różnicę części z odległością sąsiednich punktów: nawet identyczne części osiągają jego dolną granicę. Odchyłka od powierzchni od tego nie zależy.</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Wynik</translation>
    </message>
    <message>
        <source>Comparison of a copy with its original</source>
        <translation>Porównanie kopii z oryginałem</translation>
    </message>
    <message>
        <source>Method and parameters</source>
        <translation>Metoda i parametry</translation>
    </message>
    <message>
        <source>a name in .ply or .csv</source>
        <translation>nazwa z rozszerzeniem .ply lub .csv</translation>
    </message>
    <message>
        <source>Input files</source>
        <translation>Pliki wejściowe</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Plik</translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation>Bajty</translation>
    </message>
    <message>
        <source>en</source>
        <translation>pl</translation>
    </message>
    <message>
        <source>Synthetic data: made by a program, not measured</source>
        <translation>Dane syntetyczne: wytworzone programem, nie zmierzone</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>Porównywanie</translation>
    </message>
    <message>
        <source>Writing deviations</source>
        <translation>Zapis odchyłek</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Delimiter</source>
        <translation>Separator</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Wiersze</translation>
    </message>
    <message>
        <source>Columns</source>
        <translation>Kolumny</translation>
    </message>
    <message>
        <source>Smallest x, y, z (mm)</source>
        <translation>Najmniejsze x, y, z (mm)</translation>
    </message>
    <message>
        <source>Largest x, y, z (mm)</source>
        <translation>Największe x, y, z (mm)</translation>
    </message>
    <message>
        <source>Skipped line {line}</source>
        <translation>Pominięto wiersz {line}</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Pliki</translation>
    </message>
    <message>
        <source>What was understood of the files</source>
        <translation>Co zrozumiano z plików</translation>
    </message>
    <message>
        <source>There is no result to report yet.</source>
        <translation>Nie ma jeszcze wyniku do raportu.</translation>
    </message>
    <message>
        <source>The project has nothing to report.</source>
        <translation>Projekt nie ma nic do raportu.</translation>
    </message>
    <message>
        <source>Roundness</source>
        <translation>Okrągłość</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Oryginał</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopia</translation>
    </message>
    <message>
        <source>Point clouds and meshes</source>
        <translation>Chmury punktów i siatki</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Porównanie</translation>
    </message>
    <message>
        <source>the system refused it</source>
        <translation>odmowa systemu</translation>
    </message>
    <message>
        <source>Reading the reference</source>
        <translation>Odczyt oryginału</translation>
    </message>
    <message>
        <source>Reading the copy</source>
        <translation>Odczyt kopii</translation>
    </message>
    <message>
        <source>Original (blue) and copy (red), oblique</source>
        <translation>Oryginał (niebieski) i kopia (czerwona), ukośnie</translation>
    </message>
    <message>
        <source>Original (blue) and copy (red), from the side</source>
        <translation>Oryginał (niebieski) i kopia (czerwona), z boku</translation>
    </message>
    <message>
        <source>Deviation of the copy, oblique</source>
        <translation>Odchyłka kopii, ukośnie</translation>
    </message>
    <message>
        <source>Deviation of the copy, from the side</source>
        <translation>Odchyłka kopii, z boku</translation>
    </message>
    <message>
        <source>{path}: synthetic data, made by a program, not measured.</source>
        <translation>{path}: dane syntetyczne, wytworzone programem, nie zmierzone.</translation>
    </message>
    <message>
        <source>a shorter statement</source>
        <translation>krótszy zapis</translation>
    </message>
    <message>
        <source>Unrolled surface: tolerance</source>
        <translation>Rozwinięcie powierzchni: tolerancja</translation>
    </message>
    <message>
        <source>Unrolled surface: form of the deviation</source>
        <translation>Rozwinięcie powierzchni: kształt odchyłki</translation>
    </message>
    <message>
        <source>{count} poses fit equally well; the one with the smallest rotation was chosen.</source>
        <translation>Równie dobrze pasuje kilka położeń (liczba: {count}); wybrano to o najmniejszym obrocie.</translation>
    </message>
    <message>
        <source>symmetry is not to be used</source>
        <translation>symetrii nie należy używać</translation>
    </message>
    <message>
        <source>the reference is not a body of revolution</source>
        <translation>oryginał nie jest bryłą obrotową</translation>
    </message>
    <message>
        <source>both parts are bodies of revolution</source>
        <translation>obie części są bryłami obrotowymi</translation>
    </message>
    <message>
        <source>the copy is not a body of revolution</source>
        <translation>kopia nie jest bryłą obrotową</translation>
    </message>
    <message>
        <source>a body of revolution, which has an axis</source>
        <translation>bryła obrotowa, która ma oś</translation>
    </message>
    <message>
        <source>root mean square</source>
        <translation>średnia kwadratowa</translation>
    </message>
    <message>
        <source>root mean square error</source>
        <translation>średni błąd kwadratowy</translation>
    </message>
    <message>
        <source>peak-to-valley roundness deviation</source>
        <translation>odchyłka okrągłości, od wzniesienia do wgłębienia</translation>
    </message>
    <message>
        <source>peak-to-reference roundness deviation</source>
        <translation>odchyłka okrągłości, wzniesienie nad okręgiem odniesienia</translation>
    </message>
    <message>
        <source>reference-to-valley roundness deviation</source>
        <translation>odchyłka okrągłości, wgłębienie pod okręgiem odniesienia</translation>
    </message>
    <message>
        <source>root mean square roundness deviation</source>
        <translation>średniokwadratowa odchyłka okrągłości</translation>
    </message>
    <message>
        <source>peak-to-valley cylindricity deviation</source>
        <translation>odchyłka walcowości, od wzniesienia do wgłębienia</translation>
    </message>
    <message>
        <source>least squares reference circle</source>
        <translation>średni okrąg odniesienia (najmniejszych kwadratów)</translation>
    </message>
    <message>
        <source>minimum zone reference circles</source>
        <translation>okręgi odniesienia o najmniejszej strefie</translation>
    </message>
    <message>
        <source>maximum inscribed reference circle</source>
        <translation>największy okrąg wpisany</translation>
    </message>
    <message>
        <source>minimum circumscribed reference circle</source>
        <translation>najmniejszy okrąg opisany</translation>
    </message>
    <message>
        <source>least squares reference cylinder</source>
        <translation>średni walec odniesienia (najmniejszych kwadratów)</translation>
    </message>
    <message>
        <source>minimum zone reference cylinders</source>
        <translation>walce odniesienia o najmniejszej strefie</translation>
    </message>
    <message>
        <source>undulations per revolution</source>
        <translation>liczba fal na obrót</translation>
    </message>
    <message>
        <source>Gaussian filter</source>
        <translation>filtr Gaussa</translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation>odchylenie standardowe</translation>
    </message>
    <message>
        <source>median absolute deviation</source>
        <translation>mediana odchyleń bezwzględnych</translation>
    </message>
    <message>
        <source>The columns cannot be told: found “{found}”, expected {expected}.</source>
        <translation>Nie można rozpoznać kolumn: znaleziono „{found}”, oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The file holds deviations only, from {minimum} to {maximum}. State the nominal radius.</source>
        <translation>Plik zawiera same odchyłki, od {minimum} do {maximum}. Podaj promień nominalny.</translation>
    </message>
    <message>
        <source>The record is not complete: {partner} is not beside it.</source>
        <translation>Zapis jest niepełny: obok nie ma pliku {partner}.</translation>
    </message>
    <message>
        <source>The record contradicts itself ({check}): found {found}, expected {expected}.</source>
        <translation>Zapis jest wewnętrznie sprzeczny ({check}): znaleziono {found}, oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>{path}: the points lie in the plane {plane} at {at_mm} mm; read as a profile in it.</source>
        <translation>{path}: punkty leżą w płaszczyźnie {plane} na {at_mm} mm; odczytano jako profil w niej.</translation>
    </message>
    <message>
        <source>{path}: {coordinate} runs from {from_mm} to {to_mm} mm; all points were read as one section.</source>
        <translation>{path}: {coordinate} biegnie od {from_mm} do {to_mm} mm; wszystkie punkty odczytano jako jeden przekrój.</translation>
    </message>
    <message>
        <source>{path}: the columns have no names; read as {columns}.</source>
        <translation>{path}: kolumny nie mają nazw; odczytano jako {columns}.</translation>
    </message>
    <message>
        <source>{path}: no unit of the angle is stated; read as rad because it runs over {extent}.</source>
        <translation>{path}: nie podano jednostki kąta; odczytano jako rad, bo obejmuje {extent}.</translation>
    </message>
    <message>
        <source>{path}: no angles are stated; {count} values were spread evenly over one turn.</source>
        <translation>{path}: nie podano kątów; wartości rozłożono równo na jednym obrocie, ich liczba: {count}.</translation>
    </message>
    <message>
        <source>{path}: deviations laid on the nominal radius of {radius_mm} mm; the size is not measured.</source>
        <translation>{path}: odchyłki odłożono na promieniu nominalnym {radius_mm} mm; wymiar nie jest zmierzony.</translation>
    </message>
    <message>
        <source>{path}: the file holds radii; the nominal radius of {radius_mm} mm is not used.</source>
        <translation>{path}: plik zawiera promienie; promień nominalny {radius_mm} mm nie jest użyty.</translation>
    </message>
    <message>
        <source>{path}: no unit of the time is stated; read as seconds.</source>
        <translation>{path}: nie podano jednostki czasu; odczytano jako sekundy.</translation>
    </message>
    <message>
        <source>{path}: the times are written too coarsely; {rate_hz} frames a second were used instead.</source>
        <translation>{path}: czasy zapisano zbyt zgrubnie; zamiast nich przyjęto {rate_hz} ramek na sekundę.</translation>
    </message>
    <message>
        <source>{path}: neither times nor a rate are stated.</source>
        <translation>{path}: nie podano ani czasów, ani częstości próbkowania.</translation>
    </message>
    <message>
        <source>{path}: no unit of {channel} is stated.</source>
        <translation>{path}: nie podano jednostki kanału {channel}.</translation>
    </message>
    <message>
        <source>{path}: the stated converter rate of {stated_kHz} kHz does not fit {channels} channels; {used_kHz} kHz was used.</source>
        <translation>{path}: podana częstość przetwornika {stated_kHz} kHz nie pasuje do liczby kanałów {channels}; przyjęto {used_kHz} kHz.</translation>
    </message>
    <message>
        <source>{path}: the stated delay of {stated_ms} ms does not fit the rates; {used_ms} ms from channel to channel was used.</source>
        <translation>{path}: podane opóźnienie {stated_ms} ms nie pasuje do częstości; między kanałami przyjęto {used_ms} ms.</translation>
    </message>
    <message>
        <source>{path}: {full_scale_code} converter codes of {device} were read as {volts} V.</source>
        <translation>{path}: kod przetwornika {full_scale_code} urządzenia {device} odczytano jako {volts} V.</translation>
    </message>
    <message>
        <source>{path}: the recorder {device} is not known; the values are converter codes. State the full scale.</source>
        <translation>{path}: rejestrator {device} nie jest znany; wartości są kodami przetwornika. Podaj pełny zakres.</translation>
    </message>
    <message>
        <source>{path}: the recording has {count} segments; there may be gaps between them.</source>
        <translation>{path}: zapis ma segmenty w liczbie {count}; między nimi mogą być przerwy.</translation>
    </message>
    <message>
        <source>a value, for a decision with uncertainty</source>
        <translation>wartość, dla decyzji z niepewnością</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancja</translation>
    </message>
    <message>
        <source>Largest cylindricity deviation CYLt allowed.</source>
        <translation>Największa dopuszczalna odchyłka walcowości CYLt.</translation>
    </message>
    <message>
        <source>Simple</source>
        <translation>Prosta</translation>
    </message>
    <message>
        <source>Decision rule</source>
        <translation>Reguła decyzyjna</translation>
    </message>
    <message>
        <source>Uncertainty of a point</source>
        <translation>Niepewność punktu</translation>
    </message>
    <message>
        <source>One standard deviation.</source>
        <translation>Jedno odchylenie standardowe.</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>ramki</translation>
    </message>
    <message>
        <source>size of the .dat file</source>
        <translation>wielkość pliku .dat</translation>
    </message>
    <message>
        <source>Full-scale code</source>
        <translation>Kod pełnego zakresu</translation>
    </message>
    <message>
        <source>Converter code of the full-scale voltage at gain 1; by default the recorder&apos;s own.</source>
        <translation>Kod przetwornika odpowiadający napięciu pełnego zakresu przy wzmocnieniu 1; domyślnie właściwy dla rejestratora.</translation>
    </message>
    <message>
        <source>Full-scale voltage</source>
        <translation>Napięcie pełnego zakresu</translation>
    </message>
    <message>
        <source>Voltage of the full-scale code at gain 1; by default the recorder&apos;s own.</source>
        <translation>Napięcie odpowiadające kodowi pełnego zakresu przy wzmocnieniu 1; domyślnie właściwe dla rejestratora.</translation>
    </message>
    <message>
        <source>a number above 0</source>
        <translation>liczba większa od 0</translation>
    </message>
    <message>
        <source>number of channels</source>
        <translation>liczba kanałów</translation>
    </message>
    <message>
        <source>1 to 32</source>
        <translation>od 1 do 32</translation>
    </message>
    <message>
        <source>gain code</source>
        <translation>kod wzmocnienia</translation>
    </message>
    <message>
        <source>0 to 3</source>
        <translation>od 0 do 3</translation>
    </message>
    <message>
        <source>active channels</source>
        <translation>czynne kanały</translation>
    </message>
    <message>
        <source>samples = frames × channels</source>
        <translation>próbki = ramki × kanały</translation>
    </message>
    <message>
        <source>frames, stated twice</source>
        <translation>ramki, podane dwukrotnie</translation>
    </message>
    <message>
        <source>total time = frames / rate</source>
        <translation>czas całkowity = ramki / częstość</translation>
    </message>
    <message>
        <source>converter rate ≥ rate × channels</source>
        <translation>częstość przetwornika ≥ częstość × kanały</translation>
    </message>
    <message>
        <source>another signature</source>
        <translation>inna sygnatura</translation>
    </message>
    <message>
        <source>the .par file of an L-Graph record</source>
        <translation>plik .par zapisu L-Graph</translation>
    </message>
    <message>
        <source>size of the .par file</source>
        <translation>wielkość pliku .par</translation>
    </message>
    <message>
        <source>rate per channel</source>
        <translation>częstość na kanał</translation>
    </message>
    <message>
        <source>total time</source>
        <translation>czas całkowity</translation>
    </message>
    <message>
        <source>a probe record as text</source>
        <translation>zapis czujników jako tekst</translation>
    </message>
    <message>
        <source>coordinates</source>
        <translation>współrzędne</translation>
    </message>
    <message>
        <source>displacements in units of length</source>
        <translation>przemieszczenia w jednostkach długości</translation>
    </message>
    <message>
        <source>columns named X3, Y3, Xp and Yp</source>
        <translation>kolumny o nazwach X3, Y3, Xp i Yp</translation>
    </message>
    <message>
        <source>the number of a section</source>
        <translation>numer przekroju</translation>
    </message>
    <message>
        <source>at most 10000 sections</source>
        <translation>najwyżej 10000 przekrojów</translation>
    </message>
    <message>
        <source>one z for a section</source>
        <translation>jedno z dla przekroju</translation>
    </message>
    <message>
        <source>a later time than in the row before</source>
        <translation>czas późniejszy niż w poprzednim wierszu</translation>
    </message>
    <message>
        <source>no column of signals</source>
        <translation>brak kolumny sygnałów</translation>
    </message>
    <message>
        <source>channels such as marker_V, X3_um</source>
        <translation>kanały takie jak marker_V, X3_um</translation>
    </message>
    <message>
        <source>columns named x and y</source>
        <translation>kolumny o nazwach x i y</translation>
    </message>
    <message>
        <source>columns named angle and r</source>
        <translation>kolumny o nazwach angle i r</translation>
    </message>
    <message>
        <source>columns named x and y, or angle and r</source>
        <translation>kolumny o nazwach x i y albo angle i r</translation>
    </message>
    <message>
        <source>a probe record</source>
        <translation>zapis czujników</translation>
    </message>
    <message>
        <source>a profile: x and y, or angle and r</source>
        <translation>profil: x i y albo kąt i r</translation>
    </message>
    <message>
        <source>names, or to be told whether they are x,y or angle,radius</source>
        <translation>nazwy albo wskazanie, czy są to x,y czy kąt,promień</translation>
    </message>
    <message>
        <source>a profile as text: x and y, or angle and r</source>
        <translation>profil jako tekst: x i y albo kąt i r</translation>
    </message>
    <message>
        <source>one unit for all coordinates</source>
        <translation>jedna jednostka wszystkich współrzędnych</translation>
    </message>
    <message>
        <source>x and y, or x, y and z in a coordinate plane</source>
        <translation>x i y albo x, y i z w płaszczyźnie współrzędnych</translation>
    </message>
    <message>
        <source>angle, radius</source>
        <translation>kąt, promień</translation>
    </message>
    <message>
        <source>What the columns of a profile without names hold.</source>
        <translation>Co zawierają kolumny profilu bez nazw.</translation>
    </message>
    <message>
        <source>Nominal radius</source>
        <translation>Promień nominalny</translation>
    </message>
    <message>
        <source>Radius that the deviations are laid on, when a file holds nothing but deviations.</source>
        <translation>Promień, na którym odkłada się odchyłki, gdy plik zawiera tylko odchyłki.</translation>
    </message>
    <message>
        <source>Least-squares circle</source>
        <translation>Okrąg najmniejszych kwadratów</translation>
    </message>
    <message>
        <source>Minimum-zone circle</source>
        <translation>Okręgi najmniejszej strefy</translation>
    </message>
    <message>
        <source>Maximum inscribed circle</source>
        <translation>Największy okrąg wpisany</translation>
    </message>
    <message>
        <source>Minimum circumscribed circle</source>
        <translation>Najmniejszy okrąg opisany</translation>
    </message>
    <message>
        <source>Minimum zone of scattered points, by enumeration</source>
        <translation>Najmniejsza strefa punktów rozproszonych, przez wyliczenie</translation>
    </message>
    <message>
        <source>Gap certified for minimum zone and inscribed circle</source>
        <translation>Potwierdzona dokładność najmniejszej strefy i okręgu wpisanego</translation>
    </message>
    <message>
        <source>Least-squares cylinder</source>
        <translation>Walec najmniejszych kwadratów</translation>
    </message>
    <message>
        <source>Minimum-zone cylinder</source>
        <translation>Walce najmniejszej strefy</translation>
    </message>
    <message>
        <source>Straightness of an axis</source>
        <translation>Prostoliniowość osi</translation>
    </message>
    <message>
        <source>a count and as many points</source>
        <translation>liczba i tyle punktów</translation>
    </message>
    <message>
        <source>NIST reference circles, least squares</source>
        <translation>Okręgi wzorcowe NIST, najmniejsze kwadraty</translation>
    </message>
    <message>
        <source>Transmission of the Gaussian filter</source>
        <translation>Przenoszenie filtru Gaussa</translation>
    </message>
    <message>
        <source>Harmonics</source>
        <translation>Harmoniczne</translation>
    </message>
    <message>
        <source>a field such as K0001/1</source>
        <translation>pole takie jak K0001/1</translation>
    </message>
    <message>
        <source>the number of a characteristic</source>
        <translation>numer cechy</translation>
    </message>
    <message>
        <source>characteristics</source>
        <translation>cechy</translation>
    </message>
    <message>
        <source>a value before its attribute</source>
        <translation>wartość przed jej atrybutem</translation>
    </message>
    <message>
        <source>as many characteristics as K0100 says</source>
        <translation>tyle cech, ile podaje K0100</translation>
    </message>
    <message>
        <source>a Q-DAS file with K-fields</source>
        <translation>plik Q-DAS z polami K</translation>
    </message>
    <message>
        <source>{count} kinds of reference data refitted: all answers agree</source>
        <translation>Dopasowano ponownie rodzaje danych wzorcowych: {count}; wszystkie wyniki zgodne</translation>
    </message>
    <message>
        <source>{failed} of {count} kinds of reference data miss their answers</source>
        <translation>Rodzaje danych wzorcowych z wynikiem niezgodnym: {failed} z {count}</translation>
    </message>
    <message>
        <source>Reference data refitted</source>
        <translation>Dane wzorcowe dopasowane ponownie</translation>
    </message>
    <message>
        <source>kind</source>
        <translation>rodzaj</translation>
    </message>
    <message>
        <source>sets</source>
        <translation>zbiory</translation>
    </message>
    <message>
        <source>largest deviation</source>
        <translation>największa odchyłka</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>granica</translation>
    </message>
    <message>
        <source>verdict</source>
        <translation>orzeczenie</translation>
    </message>
    <message>
        <source>pass</source>
        <translation>zgodny</translation>
    </message>
    <message>
        <source>fail</source>
        <translation>niezgodny</translation>
    </message>
    <message>
        <source>NIST reference sets from {path}; the other sets are built in.</source>
        <translation>Zbiory wzorcowe NIST z {path}; pozostałe są wbudowane.</translation>
    </message>
    <message>
        <source>Verification of the installation</source>
        <translation>Sprawdzenie instalacji</translation>
    </message>
    <message>
        <source>Each set is fitted anew by this program on this computer. The answers follow from the way the data are made (closed forms), from trying all possible contacts, or are NIST&apos;s.</source>
        <translation>Każdy zbiór jest dopasowywany od nowa tym programem na tym komputerze. Wyniki wzorcowe wynikają ze sposobu utworzenia danych (wzory zamknięte), ze sprawdzenia wszystkich możliwych styków albo pochodzą z NIST.</translation>
    </message>
    <message>
        <source>Verifying</source>
        <translation>Sprawdzanie</translation>
    </message>
    <message>
        <source>{points} points a turn are too few for {cutoff_upr} UPR by the rule of 7 points a wave; they carry {supported_upr} UPR. The answer is given all the same.</source>
        <translation>Punktów na obrót ({points}) jest za mało dla {cutoff_upr} UPR według reguły 7 punktów na falę; wystarczą dla {supported_upr} UPR. Wynik mimo to podano.</translation>
    </message>
    <message>
        <source>The points leave {missing_deg}° of the turn out: this is the roundness of an arc, and harmonics say little.</source>
        <translation>Punkty pomijają {missing_deg}° obrotu: to okrągłość łuku, a harmoniczne mówią niewiele.</translation>
    </message>
    <message>
        <source>The points are unevenly spread over the turn; filter and harmonics take that into account.</source>
        <translation>Punkty są rozłożone nierówno na obrocie; filtr i harmoniczne to uwzględniają.</translation>
    </message>
    <message>
        <source>Another centre gives the same minimum zone: RONt is sure, the centre is not.</source>
        <translation>Inny środek daje tę samą najmniejszą strefę: RONt jest pewne, środek nie.</translation>
    </message>
    <message>
        <source>Another centre holds an equal maximum inscribed circle; RONt(MICI) depends on which is taken.</source>
        <translation>Inny środek ma równy największy okrąg wpisany; RONt(MICI) zależy od wyboru.</translation>
    </message>
    <message>
        <source>{circle} is proved to {gap_um} µm only.</source>
        <translation>{circle}: potwierdzono tylko z dokładnością {gap_um} µm.</translation>
    </message>
    <message>
        <source>The noise of the points cannot be told from the form and counts as form; state the uncertainty of a point for an uncertainty of the result.</source>
        <translation>Szumu punktów nie da się odróżnić od kształtu i liczy się on jako kształt; podaj niepewność punktu, aby otrzymać niepewność wyniku.</translation>
    </message>
    <message>
        <source>The profile holds deviations from a nominal radius: form is measured, size is not.</source>
        <translation>Profil zawiera odchyłki od promienia nominalnego: kształt jest zmierzony, wymiar nie.</translation>
    </message>
    <message>
        <source>The form does not determine the angle between the profiles; several rotations fit as well.</source>
        <translation>Kształt nie wyznacza kąta między profilami; kilka obrotów pasuje równie dobrze.</translation>
    </message>
    <message>
        <source>eccentricity: how the part sat on the measuring axis; no form</source>
        <translation>mimośród: ustawienie części względem osi pomiaru; to nie kształt</translation>
    </message>
    <message>
        <source>oval: clamping between two jaws, an oval spindle bearing, or an oval blank</source>
        <translation>owal: mocowanie w dwóch szczękach, owalne łożysko wrzeciona albo owalny półfabrykat</translation>
    </message>
    <message>
        <source>three lobes: the clamping force of a three-jaw chuck</source>
        <translation>trójgraniastość: siła mocowania uchwytu trójszczękowego</translation>
    </message>
    <message>
        <source>four lobes: the clamping force of a four-jaw chuck</source>
        <translation>czterograniastość: siła mocowania uchwytu czteroszczękowego</translation>
    </message>
    <message>
        <source>five lobes: centreless ground bar stock, or a five-pad clamping</source>
        <translation>pięciograniastość: pręt szlifowany bezkłowo albo mocowanie w pięciu punktach</translation>
    </message>
    <message>
        <source>six lobes: a six-jaw chuck, or three jaws that press on pairs of spots</source>
        <translation>sześciograniastość: uchwyt sześcioszczękowy albo trzy szczęki naciskające w parach punktów</translation>
    </message>
    <message>
        <source>several lobes: spindle bearing, its balls or rollers, or the drive</source>
        <translation>kilka garbów: łożysko wrzeciona, jego kulki lub wałeczki albo napęd</translation>
    </message>
    <message>
        <source>waves: vibration of workpiece or tool at a multiple of the spindle speed</source>
        <translation>fale: drgania przedmiotu lub narzędzia o krotności prędkości wrzeciona</translation>
    </message>
    <message>
        <source>short waves: chatter, or the trace of the tool&apos;s feed</source>
        <translation>krótkie fale: drgania samowzbudne albo ślad posuwu narzędzia</translation>
    </message>
    <message>
        <source>UPR</source>
        <translation>UPR</translation>
    </message>
    <message>
        <source>Filter cut-off</source>
        <translation>Granica filtru</translation>
    </message>
    <message>
        <source>Gaussian filter: waves up to so many undulations per revolution pass.</source>
        <translation>Filtr Gaussa: przechodzą fale do tylu na obrót.</translation>
    </message>
    <message>
        <source>Filter band</source>
        <translation>Pasmo filtru</translation>
    </message>
    <message>
        <source>Gaussian filter: waves between these undulations per revolution pass.</source>
        <translation>Filtr Gaussa: przechodzą fale między tymi liczbami na obrót.</translation>
    </message>
    <message>
        <source>Excluded sectors</source>
        <translation>Wyłączone sektory</translation>
    </message>
    <message>
        <source>Keyways and interruptions, as angles seen from the centre.</source>
        <translation>Rowki wpustowe i przerwy, jako kąty widziane ze środka.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Zachowaj</translation>
    </message>
    <message>
        <source>Leave out (Hampel)</source>
        <translation>Pomiń (Hampel)</translation>
    </message>
    <message>
        <source>Outliers</source>
        <translation>Punkty odstające</translation>
    </message>
    <message>
        <source>Points that stand out of their neighbours by more than 5 standard deviations.</source>
        <translation>Punkty odstające od sąsiadów o więcej niż 5 odchyleń standardowych.</translation>
    </message>
    <message>
        <source>Least squares (LSCI)</source>
        <translation>Najmniejsze kwadraty (LSCI)</translation>
    </message>
    <message>
        <source>Minimum zone (MZCI)</source>
        <translation>Najmniejsza strefa (MZCI)</translation>
    </message>
    <message>
        <source>Maximum inscribed (MICI)</source>
        <translation>Największy wpisany (MICI)</translation>
    </message>
    <message>
        <source>Minimum circumscribed (MCCI)</source>
        <translation>Najmniejszy opisany (MCCI)</translation>
    </message>
    <message>
        <source>Reference circle</source>
        <translation>Okrąg odniesienia</translation>
    </message>
    <message>
        <source>The circle of the headline and the verdict; all four are reported.</source>
        <translation>Okrąg nagłówka i orzeczenia; raport podaje wszystkie cztery.</translation>
    </message>
    <message>
        <source>Largest roundness deviation RONt allowed.</source>
        <translation>Największa dopuszczalna odchyłka okrągłości RONt.</translation>
    </message>
    <message>
        <source>One standard deviation; by default found from the profile&apos;s own noise.</source>
        <translation>Jedno odchylenie standardowe; domyślnie wyznaczane z szumu samego profilu.</translation>
    </message>
    <message>
        <source>either a cut-off or a band</source>
        <translation>albo granica, albo pasmo</translation>
    </message>
    <message>
        <source>one band such as 15:500</source>
        <translation>jedno pasmo takie jak 15:500</translation>
    </message>
    <message>
        <source>Cylindricity</source>
        <translation>Walcowość</translation>
    </message>
    <message>
        <source>Straightness of the axis of the sections</source>
        <translation>Prostoliniowość osi przekrojów</translation>
    </message>
    <message>
        <source>Radius (least squares)</source>
        <translation>Promień (najmniejsze kwadraty)</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Długość</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Osie</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>walec</translation>
    </message>
    <message>
        <source>ISO 12180: CYLt is the largest minus the smallest distance of the points from the axis of the reference cylinder. The minimum zone is locally optimal, found from several starts.</source>
        <translation>ISO 12180: CYLt to największa minus najmniejsza odległość punktów od osi walca odniesienia. Najmniejsza strefa jest lokalnie optymalna, znaleziona z kilku punktów startowych.</translation>
    </message>
    <message>
        <source>contact point, outer circle</source>
        <translation>punkt styku, okrąg zewnętrzny</translation>
    </message>
    <message>
        <source>contact point, inner circle</source>
        <translation>punkt styku, okrąg wewnętrzny</translation>
    </message>
    <message>
        <source>Deviations magnified {times} times</source>
        <translation>Odchyłki powiększone {times} razy</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>profil</translation>
    </message>
    <message>
        <source>Harmonics of the unfiltered profile</source>
        <translation>Harmoniczne profilu niefiltrowanego</translation>
    </message>
    <message>
        <source>RONt by method: how much of the value is the method?</source>
        <translation>RONt według metody: ile wartości to metoda?</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>filtr</translation>
    </message>
    <message>
        <source>outliers</source>
        <translation>punkty odstające</translation>
    </message>
    <message>
        <source>undersampled</source>
        <translation>za mało punktów</translation>
    </message>
    <message>
        <source>this result</source>
        <translation>ten wynik</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>pominięte</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>zachowane</translation>
    </message>
    <message>
        <source>Strongest harmonics</source>
        <translation>Najsilniejsze harmoniczne</translation>
    </message>
    <message>
        <source>phase (°)</source>
        <translation>faza (°)</translation>
    </message>
    <message>
        <source>share of the form (%)</source>
        <translation>udział w kształcie (%)</translation>
    </message>
    <message>
        <source>what it usually is</source>
        <translation>co to zwykle oznacza</translation>
    </message>
    <message>
        <source>least squares (LSCI)</source>
        <translation>najmniejsze kwadraty (LSCI)</translation>
    </message>
    <message>
        <source>minimum zone (MZCI)</source>
        <translation>najmniejsza strefa (MZCI)</translation>
    </message>
    <message>
        <source>maximum inscribed (MICI)</source>
        <translation>największy wpisany (MICI)</translation>
    </message>
    <message>
        <source>minimum circumscribed (MCCI)</source>
        <translation>najmniejszy opisany (MCCI)</translation>
    </message>
    <message>
        <source>Roundness deviation by reference circle</source>
        <translation>Odchyłka okrągłości według okręgu odniesienia</translation>
    </message>
    <message>
        <source>circle</source>
        <translation>okrąg</translation>
    </message>
    <message>
        <source>About the least-squares circle</source>
        <translation>Względem okręgu najmniejszych kwadratów</translation>
    </message>
    <message>
        <source>Peak to reference RONp</source>
        <translation>Wzniesienie nad odniesieniem RONp</translation>
    </message>
    <message>
        <source>Reference to valley RONv</source>
        <translation>Wgłębienie pod odniesieniem RONv</translation>
    </message>
    <message>
        <source>Root mean square RONq</source>
        <translation>Średnia kwadratowa RONq</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Promień</translation>
    </message>
    <message>
        <source>Expanded uncertainty (95 %)</source>
        <translation>Niepewność rozszerzona (95 %)</translation>
    </message>
    <message>
        <source>ISO 14253-1: only what is sure passes or fails</source>
        <translation>ISO 14253-1: uznaje się lub odrzuca tylko to, co pewne</translation>
    </message>
    <message>
        <source>simple: the value alone is compared</source>
        <translation>prosta: porównuje się samą wartość</translation>
    </message>
    <message>
        <source>Sizes across the section</source>
        <translation>Wymiary w przekroju</translation>
    </message>
    <message>
        <source>Two-point size, largest</source>
        <translation>Wymiar dwupunktowy, największy</translation>
    </message>
    <message>
        <source>Two-point size, smallest</source>
        <translation>Wymiar dwupunktowy, najmniejszy</translation>
    </message>
    <message>
        <source>Two-point size range</source>
        <translation>Rozstęp wymiaru dwupunktowego</translation>
    </message>
    <message>
        <source>Half of it: ovality by GOST 24642</source>
        <translation>Jego połowa: owalność według GOST 24642</translation>
    </message>
    <message>
        <source>Width between jaws, largest</source>
        <translation>Szerokość między szczękami, największa</translation>
    </message>
    <message>
        <source>Width between jaws, smallest</source>
        <translation>Szerokość między szczękami, najmniejsza</translation>
    </message>
    <message>
        <source>As in the source paper, about the origin of the coordinates; not roundness</source>
        <translation>Jak w artykule źródłowym, względem początku układu; to nie okrągłość</translation>
    </message>
    <message>
        <source>Radial run-out about the spindle axis</source>
        <translation>Bicie promieniowe względem osi wrzeciona</translation>
    </message>
    <message>
        <source>Centre by the limaçon formula, x</source>
        <translation>Środek ze wzoru na ślimak Pascala, x</translation>
    </message>
    <message>
        <source>Centre by the limaçon formula, y</source>
        <translation>Środek ze wzoru na ślimak Pascala, y</translation>
    </message>
    <message>
        <source>Uncertainty</source>
        <translation>Niepewność</translation>
    </message>
    <message>
        <source>Standard deviation of a point</source>
        <translation>Odchylenie standardowe punktu</translation>
    </message>
    <message>
        <source>All profiles</source>
        <translation>Wszystkie profile</translation>
    </message>
    <message>
        <source>The uncertainty is half of an interval about the value that holds the deviation without noise in 95 of 100 measurements (JCGM 101): the noise of the points is drawn anew, filtered and fitted. The table shows what other methods would say of the same points.</source>
        <translation>Niepewność to połowa przedziału wokół wartości, który w 95 na 100 pomiarów zawiera odchyłkę bez szumu (JCGM 101): szum punktów jest losowany od nowa, filtrowany i dopasowywany. Tabela pokazuje, co inne metody powiedziałyby o tych samych punktach.</translation>
    </message>
    <message>
        <source>no filter</source>
        <translation>bez filtru</translation>
    </message>
    <message>
        <source>✓ within tolerance</source>
        <translation>✓ w tolerancji</translation>
    </message>
    <message>
        <source>✗ out of tolerance</source>
        <translation>✗ poza tolerancją</translation>
    </message>
    <message>
        <source>? not decided: too near the tolerance</source>
        <translation>? nierozstrzygnięte: zbyt blisko tolerancji</translation>
    </message>
    <message>
        <source>Overview</source>
        <translation>Przegląd</translation>
    </message>
    <message>
        <source>ISO 12181: RONt is the largest minus the smallest distance of the profile from the centre of the reference circle. Filter: Gaussian, ISO 16610-21. The minimum zone and the inscribed circle are proved by branch and bound.</source>
        <translation>ISO 12181: RONt to największa minus najmniejsza odległość profilu od środka okręgu odniesienia. Filtr: Gaussa, ISO 16610-21. Najmniejszą strefę i okrąg wpisany potwierdzono metodą podziału i ograniczeń.</translation>
    </message>
    <message>
        <source>The second profile laid on the first</source>
        <translation>Drugi profil nałożony na pierwszy</translation>
    </message>
    <message>
        <source>Largest difference</source>
        <translation>Największa różnica</translation>
    </message>
    <message>
        <source>Mean difference</source>
        <translation>Średnia różnica</translation>
    </message>
    <message>
        <source>Root mean square difference</source>
        <translation>Średnia kwadratowa różnica</translation>
    </message>
    <message>
        <source>Correlation of the forms</source>
        <translation>Korelacja kształtów</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Obrót o</translation>
    </message>
    <message>
        <source>Mirrored</source>
        <translation>Odbicie lustrzane</translation>
    </message>
    <message>
        <source>Shifted by, x</source>
        <translation>Przesunięcie, x</translation>
    </message>
    <message>
        <source>Shifted by, y</source>
        <translation>Przesunięcie, y</translation>
    </message>
    <message>
        <source>Radius larger by</source>
        <translation>Promień większy o</translation>
    </message>
    <message>
        <source>Both profiles</source>
        <translation>Oba profile</translation>
    </message>
    <message>
        <source>first</source>
        <translation>pierwszy</translation>
    </message>
    <message>
        <source>second</source>
        <translation>drugi</translation>
    </message>
    <message>
        <source>Superimposed profiles</source>
        <translation>Profile nałożone</translation>
    </message>
    <message>
        <source>Fitting cylinders</source>
        <translation>Dopasowywanie walców</translation>
    </message>
    <message>
        <source>no filter beside it</source>
        <translation>bez drugiego filtru obok</translation>
    </message>
    <message>
        <source>one profile to lay the other on</source>
        <translation>jeden profil, na który nakłada się drugi</translation>
    </message>
    <message>
        <source>Evaluating</source>
        <translation>Obliczanie</translation>
    </message>
    <message>
        <source>No filter</source>
        <translation>Bez filtru</translation>
    </message>
    <message>
        <source>Evaluate the points as they are; this is the default.</source>
        <translation>Oceń punkty takie, jakie są; to ustawienie domyślne.</translation>
    </message>
    <message>
        <source>Lay the profile of this file on the one given: rotation and centre fitted.</source>
        <translation>Nałóż profil z tego pliku na podany: dopasowuje się obrót i środek.</translation>
    </message>
    <message>
        <source>Superimpose also the other way round.</source>
        <translation>Nałóż także w odbiciu.</translation>
    </message>
    <message>
        <source>The record does not say the workpiece&apos;s diameter. State it.</source>
        <translation>Zapis nie podaje średnicy przedmiotu. Podaj ją.</translation>
    </message>
    <message>
        <source>{signal} cannot be channel {found}: {reason}. The record has {channels} channels, counted from 0.</source>
        <translation>{signal} nie może być kanałem {found}: {reason}. Zapis ma {channels} kanałów, licząc od 0.</translation>
    </message>
    <message>
        <source>{signal}: channel {found} ({channel}) states no unit; expected µm, mm or V in its heading, such as X3_um.</source>
        <translation>{signal}: kanał {found} ({channel}) nie podaje jednostki; w nagłówku oczekiwano µm, mm lub V, np. X3_um.</translation>
    </message>
    <message>
        <source>Channel {place} ({channel}) is no marker of revolutions: {reason}.</source>
        <translation>Kanał {place} ({channel}) nie jest znacznikiem obrotów: {reason}.</translation>
    </message>
    <message>
        <source>Channel {place} ({channel}) is no marker of revolutions: {reason}. Channel {candidate} ({candidate_channel}) looks like one.</source>
        <translation>Kanał {place} ({channel}) nie jest znacznikiem obrotów: {reason}. Kanał {candidate} ({candidate_channel}) na niego wygląda.</translation>
    </message>
    <message>
        <source>Channel {place} ({channel}) is no angle of revolution: {reason}.</source>
        <translation>Kanał {place} ({channel}) nie jest kątem obrotu: {reason}.</translation>
    </message>
    <message>
        <source>The time does not go forward at row {row}.</source>
        <translation>Czas nie rośnie w wierszu {row}.</translation>
    </message>
    <message>
        <source>{found} whole revolutions are too few; at least {minimum} are needed.</source>
        <translation>{found} pełnych obrotów to za mało; potrzeba co najmniej {minimum}.</translation>
    </message>
    <message>
        <source>{found} revolutions are too few for {sections} sections; at least {minimum} are needed.</source>
        <translation>{found} obrotów to za mało na {sections} przekrojów; potrzeba co najmniej {minimum}.</translation>
    </message>
    <message>
        <source>The records are not of one workpiece: {parameter} is {first} in the first and {found} here.</source>
        <translation>Zapisy nie dotyczą jednego przedmiotu: {parameter} wynosi {first} w pierwszym, a tutaj {found}.</translation>
    </message>
    <message>
        <source>{path}: {signal} ({channel}) stands still; is the probe connected?</source>
        <translation>{path}: {signal} ({channel}) nie zmienia się; czy czujnik jest podłączony?</translation>
    </message>
    <message>
        <source>{path}: {signal} ({channel}) rests at the end of its range for {share_percent} % of the time; the probe was out of range.</source>
        <translation>{path}: {signal} ({channel}) pozostaje na końcu zakresu przez {share_percent} % czasu; czujnik był poza zakresem.</translation>
    </message>
    <message>
        <source>{path}: {signal} reaches {largest_um} µm, more than a probe measures; check the sensitivity and the channels.</source>
        <translation>{path}: {signal} osiąga {largest_um} µm, więcej niż mierzy czujnik; sprawdź czułość i kanały.</translation>
    </message>
    <message>
        <source>{path}: the delay from channel to channel is not known; taken as none.</source>
        <translation>{path}: opóźnienie między kanałami jest nieznane; przyjęto zerowe.</translation>
    </message>
    <message>
        <source>{path}: {found} revolutions in a section instead of {asked}.</source>
        <translation>{path}: {found} obrotów w przekroju zamiast {asked}.</translation>
    </message>
    <message>
        <source>{path}: the marks come {found_rpm} times a minute, the record says {stated_rpm} rpm.</source>
        <translation>{path}: znaczniki pojawiają się {found_rpm} razy na minutę, zapis podaje {stated_rpm} obr/min.</translation>
    </message>
    <message>
        <source>A longitudinal section needs sections at {minimum} different places; there are {found}.</source>
        <translation>Przekrój podłużny wymaga przekrojów w {minimum} różnych miejscach; jest ich {found}.</translation>
    </message>
    <message>
        <source>The diameter of {diameter_mm} mm is nominal: form is measured, size is referenced to it.</source>
        <translation>Średnica {diameter_mm} mm jest nominalna: zmierzono kształt, wymiar jest do niej odniesiony.</translation>
    </message>
    <message>
        <source>Two probes cannot tell the mandrel&apos;s own form (up to {form_um} µm) from its motion: nothing smaller is resolved.</source>
        <translation>Dwa czujniki nie odróżnią kształtu trzpienia (do {form_um} µm) od jego ruchu: mniejszych wielkości nie widać.</translation>
    </message>
    <message>
        <source>{path}: averages over revolutions; asynchronous motion and single revolutions are not known.</source>
        <translation>{path}: średnie z obrotów; ruch asynchroniczny i pojedyncze obroty są nieznane.</translation>
    </message>
    <message>
        <source>Longitudinal section</source>
        <translation>Przekrój podłużny</translation>
    </message>
    <message>
        <source>sections</source>
        <translation>przekroje</translation>
    </message>
    <message>
        <source>Roundness of the sections</source>
        <translation>Okrągłość przekrojów</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Przekrój</translation>
    </message>
    <message>
        <source>Trajectories over one turn</source>
        <translation>Trajektorie w ciągu obrotu</translation>
    </message>
    <message>
        <source>axis of the workpiece (X3, Y3)</source>
        <translation>oś przedmiotu (X3, Y3)</translation>
    </message>
    <message>
        <source>tool (Xp, Yp)</source>
        <translation>narzędzie (Xp, Yp)</translation>
    </message>
    <message>
        <source>Radius about the spindle axis</source>
        <translation>Promień względem osi wrzeciona</translation>
    </message>
    <message>
        <source>single revolutions: from the smallest to the largest</source>
        <translation>pojedyncze obroty: od najmniejszego do największego</translation>
    </message>
    <message>
        <source>single revolutions</source>
        <translation>pojedyncze obroty</translation>
    </message>
    <message>
        <source>Taper on diameter (+ grows from the free end)</source>
        <translation>Stożkowość na średnicy (+ rośnie od wolnego końca)</translation>
    </message>
    <message>
        <source>Barrel on radius (+ barrel, - saddle)</source>
        <translation>Baryłkowość na promieniu (+ baryłka, − siodło)</translation>
    </message>
    <message>
        <source>Range of the diameters</source>
        <translation>Rozstęp średnic</translation>
    </message>
    <message>
        <source>Half of it, as GOST 24642-81 has it</source>
        <translation>Jego połowa, jak w GOST 24642-81</translation>
    </message>
    <message>
        <source>Straightness of the axis</source>
        <translation>Prostoliniowość osi</translation>
    </message>
    <message>
        <source>Straightness of the profile (residual about its line)</source>
        <translation>Prostoliniowość profilu (reszta względem prostej)</translation>
    </message>
    <message>
        <source>Cylindricity CYLt(LSCY)</source>
        <translation>Walcowość CYLt(LSCY)</translation>
    </message>
    <message>
        <source>Cylindricity CYLt(MZCY), locally optimal</source>
        <translation>Walcowość CYLt(MZCY), lokalnie optymalna</translation>
    </message>
    <message>
        <source>The section with the largest deviation</source>
        <translation>Przekrój o największej odchyłce</translation>
    </message>
    <message>
        <source>From the free end</source>
        <translation>Od wolnego końca</translation>
    </message>
    <message>
        <source>Radial run-out about the spindle axis (the paper&apos;s; not roundness)</source>
        <translation>Bicie promieniowe względem osi wrzeciona (z artykułu; to nie okrągłość)</translation>
    </message>
    <message>
        <source>All sections</source>
        <translation>Wszystkie przekroje</translation>
    </message>
    <message>
        <source>section</source>
        <translation>przekrój</translation>
    </message>
    <message>
        <source>revolutions</source>
        <translation>obroty</translation>
    </message>
    <message>
        <source>Error motion (ISO 230-7), without mean and eccentricity</source>
        <translation>Bicie (ISO 230-7), bez średniej i mimośrodowości</translation>
    </message>
    <message>
        <source>signal</source>
        <translation>sygnał</translation>
    </message>
    <message>
        <source>drift (µm/rev)</source>
        <translation>dryft (µm/obr)</translation>
    </message>
    <message>
        <source>rotating direction</source>
        <translation>kierunek obracający się</translation>
    </message>
    <message>
        <source>Cutting data, as the record states them</source>
        <translation>Dane skrawania według zapisu</translation>
    </message>
    <message>
        <source>Along the workpiece</source>
        <translation>Wzdłuż przedmiotu</translation>
    </message>
    <message>
        <source>Motion of spindle and tool in that section</source>
        <translation>Ruch wrzeciona i narzędzia w tym przekroju</translation>
    </message>
    <message>
        <source>Trajectories and the machined surface</source>
        <translation>Trajektorie i obrobiona powierzchnia</translation>
    </message>
    <message>
        <source>Image of the surface in the section with the largest deviation</source>
        <translation>Obraz powierzchni w przekroju o największej odchyłce</translation>
    </message>
    <message>
        <source>The image of the surface is the path of the tool as seen from the axis of the workpiece: radius |AP| with A = (X3, Y3), P = (D/2 + Xp, Yp), at the angle of the spindle plus atan2(Y3 - Yp, D/2 - X3 + Xp). Diameters are referenced to the nominal one. Roundness by ISO 12181 about the fitted centre.</source>
        <translation>Obraz powierzchni to droga narzędzia widziana z osi przedmiotu: promień |AP|, gdzie A = (X3, Y3), P = (D/2 + Xp, Yp), pod kątem wrzeciona plus atan2(Y3 - Yp, D/2 - X3 + Xp). Średnice odniesiono do nominalnej. Okrągłość według ISO 12181 względem dopasowanego środka.</translation>
    </message>
    <message>
        <source>signal=channel, such as X3=1</source>
        <translation>sygnał=kanał, np. X3=1</translation>
    </message>
    <message>
        <source>each signal once</source>
        <translation>każdy sygnał raz</translation>
    </message>
    <message>
        <source>there is no such channel</source>
        <translation>nie ma takiego kanału</translation>
    </message>
    <message>
        <source>no channel has this name</source>
        <translation>żaden kanał nie ma tej nazwy</translation>
    </message>
    <message>
        <source>it holds angles, not displacements</source>
        <translation>zawiera kąty, nie przemieszczenia</translation>
    </message>
    <message>
        <source>it holds no angles</source>
        <translation>nie zawiera kątów</translation>
    </message>
    <message>
        <source>each channel once</source>
        <translation>każdy kanał raz</translation>
    </message>
    <message>
        <source>it has hardly any values</source>
        <translation>prawie nie ma wartości</translation>
    </message>
    <message>
        <source>it stands still</source>
        <translation>nie zmienia się</translation>
    </message>
    <message>
        <source>it does not rest on two levels, as a marker does</source>
        <translation>nie przyjmuje dwóch poziomów jak znacznik</translation>
    </message>
    <message>
        <source>the record</source>
        <translation>zapis</translation>
    </message>
    <message>
        <source>a threshold between the levels</source>
        <translation>próg między poziomami</translation>
    </message>
    <message>
        <source>its pulses follow each other within a few frames</source>
        <translation>impulsy następują po sobie co kilka ramek</translation>
    </message>
    <message>
        <source>its pulses come at irregular times</source>
        <translation>impulsy pojawiają się nieregularnie</translation>
    </message>
    <message>
        <source>it makes no whole turn</source>
        <translation>nie wykonuje pełnego obrotu</translation>
    </message>
    <message>
        <source>it runs back and forth</source>
        <translation>biegnie tam i z powrotem</translation>
    </message>
    <message>
        <source>its turns follow each other within a few frames</source>
        <translation>jego obroty następują po sobie co kilka ramek</translation>
    </message>
    <message>
        <source>the workpiece&apos;s diameter</source>
        <translation>średnica przedmiotu</translation>
    </message>
    <message>
        <source>one continuous record, and no places of its sections</source>
        <translation>jeden ciągły zapis bez położeń przekrojów</translation>
    </message>
    <message>
        <source>one place for each section</source>
        <translation>jedno położenie na przekrój</translation>
    </message>
    <message>
        <source>Finding revolutions</source>
        <translation>Wyszukiwanie obrotów</translation>
    </message>
    <message>
        <source>Evaluating sections</source>
        <translation>Ocena przekrojów</translation>
    </message>
    <message>
        <source>Workpiece diameter</source>
        <translation>Średnica przedmiotu</translation>
    </message>
    <message>
        <source>Nominal; by default as the record says. Form is measured, size is not.</source>
        <translation>Nominalna; domyślnie według zapisu. Mierzy się kształt, nie wymiar.</translation>
    </message>
    <message>
        <source>Angles of a revolution</source>
        <translation>Kąty obrotu</translation>
    </message>
    <message>
        <source>Every revolution is sampled anew at so many even angles.</source>
        <translation>Każdy obrót próbkuje się na nowo w tylu równych kątach.</translation>
    </message>
    <message>
        <source>Revolutions of a section</source>
        <translation>Obroty przekroju</translation>
    </message>
    <message>
        <source>So many are averaged; fewer when the record is shorter.</source>
        <translation>Tyle się uśrednia; mniej, gdy zapis jest krótszy.</translation>
    </message>
    <message>
        <source>Delay from channel to channel</source>
        <translation>Opóźnienie między kanałami</translation>
    </message>
    <message>
        <source>A multiplexed converter samples each channel so much after the one before.</source>
        <translation>Przetwornik z multiplekserem próbkuje każdy kanał o tyle później od poprzedniego.</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanały</translation>
    </message>
    <message>
        <source>Which channel is which signal, counted from 0: marker=0 or angle=0, X3=1, Y3=2, Xp=3, Yp=4; -X3=1 turns a sign.</source>
        <translation>Który kanał jest którym sygnałem, licząc od 0: marker=0 lub angle=0, X3=1, Y3=2, Xp=3, Yp=4; -X3=1 zmienia znak.</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Czułość</translation>
    </message>
    <message>
        <source>µm/V</source>
        <translation>µm/V</translation>
    </message>
    <message>
        <source>Marker threshold</source>
        <translation>Próg znacznika</translation>
    </message>
    <message>
        <source>By default half way between the marker&apos;s two levels.</source>
        <translation>Domyślnie w połowie między dwoma poziomami znacznika.</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>As recorded</source>
        <translation>Jak w zapisie</translation>
    </message>
    <message>
        <source>Opposite</source>
        <translation>Przeciwnie</translation>
    </message>
    <message>
        <source>Angle on the part</source>
        <translation>Kąt na części</translation>
    </message>
    <message>
        <source>Seen from the part, the angle may run against the spindle&apos;s.</source>
        <translation>Widziany z części kąt może biec przeciwnie do kąta wrzeciona.</translation>
    </message>
    <message>
        <source>Places of the sections</source>
        <translation>Położenia przekrojów</translation>
    </message>
    <message>
        <source>Feed</source>
        <translation>Posuw</translation>
    </message>
    <message>
        <source>Cuts one continuous record into sections along the workpiece.</source>
        <translation>Dzieli jeden ciągły zapis na przekroje wzdłuż przedmiotu.</translation>
    </message>
    <message>
        <source>mm/rev</source>
        <translation>mm/obr</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Przekroje</translation>
    </message>
    <message>
        <source>Into how many a continuous record is cut.</source>
        <translation>Na ile dzieli się ciągły zapis.</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Zachowany</translation>
    </message>
    <message>
        <source>Slope of a section removed</source>
        <translation>Usunięto nachylenie przekroju</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Dryft</translation>
    </message>
    <message>
        <source>The mean of a section stays in any case: it is the size.</source>
        <translation>Średnia przekroju zawsze pozostaje: to wymiar.</translation>
    </message>
    <message>
        <source>Left out by Hampel&apos;s rule</source>
        <translation>Pomijane według reguły Hampela</translation>
    </message>
    <message>
        <source>Samples and revolutions that stand out from the others of their section.</source>
        <translation>Próbki i obroty odstające od innych w swoim przekroju.</translation>
    </message>
    <message>
        <source>Outliers from</source>
        <translation>Odstające od</translation>
    </message>
    <message>
        <source>In robust standard deviations from the median.</source>
        <translation>W odpornych odchyleniach standardowych od mediany.</translation>
    </message>
    <message>
        <source>σ</source>
        <translation>σ</translation>
    </message>
    <message>
        <source>Drop the record of a whole workpiece here, or one record for each section.</source>
        <translation>Upuść tu zapis całego przedmiotu albo po jednym zapisie na przekrój.</translation>
    </message>
    <message>
        <source>Longitudinal</source>
        <translation>Przekrój podłużny</translation>
    </message>
    <message>
        <source>Surface of all sections, deviations magnified</source>
        <translation>Powierzchnia wszystkich przekrojów, odchyłki powiększone</translation>
    </message>
    <message>
        <source>What the undulations say</source>
        <translation>Co mówią falistości</translation>
    </message>
    <message>
        <source>Usual cause</source>
        <translation>Zwykła przyczyna</translation>
    </message>
    <message>
        <source>Drop a measured profile or a probe record here.</source>
        <translation>Upuść tu zmierzony profil albo zapis czujników.</translation>
    </message>
    <message>
        <source>Probe records</source>
        <translation>Zapisy czujników</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Probe record</source>
        <translation>Zapis czujników</translation>
    </message>
    <message>
        <source>One record of all sections, or one for each: CSV or L-Graph</source>
        <translation>Jeden zapis wszystkich przekrojów albo po jednym na każdy: CSV lub L-Graph</translation>
    </message>
    <message>
        <source>Measured profile</source>
        <translation>Zmierzony profil</translation>
    </message>
    <message>
        <source>x and y, or angle and radius, of one section; goes before the record</source>
        <translation>x i y albo kąt i promień jednego przekroju; ma pierwszeństwo przed zapisem</translation>
    </message>
    <message>
        <source>Trace to lay over</source>
        <translation>Wykres do nałożenia</translation>
    </message>
    <message>
        <source>Trajectories</source>
        <translation>Trajektorie</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Sygnały</translation>
    </message>
    <message>
        <source>Laid over each other</source>
        <translation>Nałożone na siebie</translation>
    </message>
    <message>
        <source>trace</source>
        <translation>wykres</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>różnica</translation>
    </message>
    <message>
        <source>Error motion of all revolutions</source>
        <translation>Bicie wszystkich obrotów</translation>
    </message>
    <message>
        <source>Drop a probe record here: a table, or a pair .dat and .par of L-Graph.</source>
        <translation>Upuść tu zapis czujników: tabelę albo parę .dat i .par programu L-Graph.</translation>
    </message>
    <message>
        <source>Synchronous error motion</source>
        <translation>Bicie synchroniczne</translation>
    </message>
    <message>
        <source>Asynchronous error motion</source>
        <translation>Bicie asynchroniczne</translation>
    </message>
    <message>
        <source>Total error motion</source>
        <translation>Bicie całkowite</translation>
    </message>
    <message>
        <source>Motion of spindle and tool</source>
        <translation>Ruch wrzeciona i narzędzia</translation>
    </message>
    <message>
        <source>Error motion (ISO 230-7)</source>
        <translation>Bicie (ISO 230-7)</translation>
    </message>
    <message>
        <source>Trajectory</source>
        <translation>Trajektoria</translation>
    </message>
    <message>
        <source>✓ within</source>
        <translation>✓ w tolerancji</translation>
    </message>
    <message>
        <source>? undecided</source>
        <translation>? nierozstrzygnięte</translation>
    </message>
    <message>
        <source>{label} {value} {unit}: taken from {source}.</source>
        <translation>{label} {value} {unit}: źródło to {source}.</translation>
    </message>
    <message>
        <source>{path}: rows skipped: {count}.</source>
        <translation>{path}: liczba pominiętych wierszy: {count}.</translation>
    </message>
    <message>
        <source>{path}: points without finite coordinates, left out: {count}.</source>
        <translation>{path}: pominięto punkty bez skończonych współrzędnych; ich liczba: {count}.</translation>
    </message>
    <message>
        <source>{path}: normals without a direction: {count}; the normals are not used.</source>
        <translation>{path}: liczba normalnych bez kierunku: {count}; normalnych nie użyto.</translation>
    </message>
    <message>
        <source>{path}: time steps that differ from {step_s} s: {count}, the first at line {line}.</source>
        <translation>{path}: kroki czasu inne niż {step_s} s: {count}, pierwszy w wierszu {line}.</translation>
    </message>
    <message>
        <source>{path}: missing samples of {channel}: {count}.</source>
        <translation>{path}: brakujące próbki kanału {channel}: {count}.</translation>
    </message>
    <message>
        <source>Points further than {distance_mm} mm from the reference, left out: {count}.</source>
        <translation>Pominięto punkty dalsze niż {distance_mm} mm od oryginału; ich liczba: {count}.</translation>
    </message>
    <message>
        <source>Points in the excluded zones, left out: {count}.</source>
        <translation>Pominięto punkty w strefach wyłączonych; ich liczba: {count}.</translation>
    </message>
    <message>
        <source>Gaps in the profile: {count}, the largest of {largest_deg}°. Beside them filter and harmonics rest on the points that are there.</source>
        <translation>Luki w profilu: {count}, największa {largest_deg}°. Przy nich filtr i harmoniczne opierają się na punktach, które są.</translation>
    </message>
    <message>
        <source>Points that lie where others do: {count}.</source>
        <translation>Punkty leżące w miejscu innych: {count}.</translation>
    </message>
    <message>
        <source>Outliers left out (Hampel): {count}.</source>
        <translation>Pominięto punkty odstające (Hampel); ich liczba: {count}.</translation>
    </message>
    <message>
        <source>Points in the excluded sectors, left out: {count}.</source>
        <translation>Pominięto punkty w wyłączonych sektorach; ich liczba: {count}.</translation>
    </message>
    <message>
        <source>{path}: revolutions of irregular length, left out: {count}.</source>
        <translation>{path}: pominięto obroty o nieregularnej długości; ich liczba: {count}.</translation>
    </message>
    <message>
        <source>{path}: revolutions with missing samples, left out: {count}.</source>
        <translation>{path}: pominięto obroty z brakującymi próbkami; ich liczba: {count}.</translation>
    </message>
    <message>
        <source>{path}: {used} of {found} revolutions were used, as the parameters ask.</source>
        <translation>{path}: zgodnie z parametrami użyto obrotów: {used} z {found}.</translation>
    </message>
    <message>
        <source>Left out because they stand out: revolutions {revolutions}, samples {samples}.</source>
        <translation>Pominięto odstające: obroty {revolutions}, próbki {samples}.</translation>
    </message>
    <message>
        <source>Sections without a known place along the workpiece: {count}. No longitudinal section.</source>
        <translation>Przekroje o nieznanym położeniu wzdłuż przedmiotu: {count}. Brak przekroju podłużnego.</translation>
    </message>
    <message>
        <source>numbers such as 5,10,15 or 5,5;10;15</source>
        <translation>liczby takie jak 5,10,15 lub 5,5;10;15</translation>
    </message>
    <message>
        <source>Along the workpiece from its free end, one for each: 5,10,15 or 5,5;10;15.</source>
        <translation>Wzdłuż przedmiotu od wolnego końca, po jednym na przekrój: 5,10,15 lub 5,5;10;15.</translation>
    </message>
    <message>
        <source>Section {section} of {count}, {z_mm} mm from the free end; revolutions: {turns}.</source>
        <translation>Przekrój {section} z {count}, {z_mm} mm od wolnego końca; obroty: {turns}.</translation>
    </message>
    <message>
        <source>Section {section} of {count}; revolutions: {turns}.</source>
        <translation>Przekrój {section} z {count}; obroty: {turns}.</translation>
    </message>
    <message>
        <source>profile, from {circle} (mean)</source>
        <translation>profil, od {circle} (średni)</translation>
    </message>
    <message>
        <source>profile, from {circle}</source>
        <translation>profil, od {circle}</translation>
    </message>
    <message>
        <source>the points do not lie in sections across the axis</source>
        <translation>punkty nie leżą w przekrojach poprzecznych do osi</translation>
    </message>
    <message>
        <source>there are too few sections</source>
        <translation>przekrojów jest za mało</translation>
    </message>
    <message>
        <source>Harmonics above {carried_upr} UPR are left out: the points, up to {spacing_deg}° apart, do not carry them.</source>
        <translation>Harmoniczne powyżej {carried_upr} UPR pominięto: nie pozwalają na nie punkty odległe od siebie nawet o {spacing_deg}°.</translation>
    </message>
    <message>
        <source>Harmonics above {determined_upr} UPR are estimates beside the gaps: up to {leakage_percent} % of one may stand in another.</source>
        <translation>Harmoniczne powyżej {determined_upr} UPR są z powodu luk oszacowane: do {leakage_percent} % jednej może znaleźć się w innej.</translation>
    </message>
    <message>
        <source>The values change in steps of {resolution_um} µm; the uncertainty counts them as step/√12.</source>
        <translation>Wartości zmieniają się skokami co {resolution_um} µm; niepewność uwzględnia je jako skok/√12.</translation>
    </message>
    <message>
        <source>The noise of neighbours moves together over about {points} points. Assumed: what no harmonic explains is noise; the uncertainty allows for it.</source>
        <translation>Szum sąsiednich punktów jest skorelowany na około {points} punktach. Założenie: szumem jest to, czego nie wyjaśnia żadna harmoniczna; niepewność to uwzględnia.</translation>
    </message>
    <message>
        <source>Single points that stand out of the profile: {count}, by up to {largest_um} µm. They count in RONt and in its uncertainty; the outlier rule would leave them out.</source>
        <translation>Pojedyncze punkty odstające od profilu: {count}, największe odstępstwo {largest_um} µm. Liczą się w RONt i w jego niepewności; reguła punktów odstających by je pominęła.</translation>
    </message>
    <message>
        <source>No two-point size in {share_percent} % of the directions: a gap lies opposite.</source>
        <translation>Brak wymiaru dwupunktowego w {share_percent} % kierunków: naprzeciw leży luka.</translation>
    </message>
    <message>
        <source>The trace is {eccentricity_um} µm off centre: RONt depends on the radius of {radius_mm} mm it is laid on, by up to {effect_um} µm, which the uncertainty counts. Centre the part better, or state its radius.</source>
        <translation>Zapis jest przesunięty od środka o {eccentricity_um} µm: RONt zależy od promienia {radius_mm} mm, na którym go położono, nawet o {effect_um} µm, co uwzględnia niepewność. Lepiej wycentruj część albo podaj jej promień.</translation>
    </message>
    <message>
        <source>No straightness of the axis: {reason}. Sections found: {sections}, needed: {minimum}.</source>
        <translation>Brak prostoliniowości osi: {reason}. Znalezione przekroje: {sections}, potrzebne: {minimum}.</translation>
    </message>
    <message>
        <source>circles as .ds (a count and points) and .fit (7 numbers)</source>
        <translation>okręgów w plikach .ds (liczba i punkty) i .fit (7 liczb)</translation>
    </message>
    <message>
        <source>points out of the plane of a circle</source>
        <translation>punkty poza płaszczyzną okręgu</translation>
    </message>
    <message>
        <source>a direction across no coordinate plane</source>
        <translation>kierunek nieprostopadły do żadnej płaszczyzny układu</translation>
    </message>
    <message>
        <source>a file in place of a folder</source>
        <translation>plik zamiast folderu</translation>
    </message>
    <message>
        <source>no file in .ds</source>
        <translation>brak plików .ds</translation>
    </message>
    <message>
        <source>the source text of a program</source>
        <translation>tekst źródłowy programu</translation>
    </message>
    <message>
        <source>a Q-DAS file</source>
        <translation>plik Q-DAS</translation>
    </message>
    <message>
        <source>a JSON text</source>
        <translation>tekst JSON</translation>
    </message>
    <message>
        <source>a PLY scan</source>
        <translation>skan PLY</translation>
    </message>
    <message>
        <source>a PCD scan</source>
        <translation>skan PCD</translation>
    </message>
    <message>
        <source>an STL mesh</source>
        <translation>siatkę STL</translation>
    </message>
    <message>
        <source>an OBJ mesh</source>
        <translation>siatkę OBJ</translation>
    </message>
    <message>
        <source>an IGES file</source>
        <translation>plik IGES</translation>
    </message>
    <message>
        <source>a DXF drawing</source>
        <translation>rysunek DXF</translation>
    </message>
    <message>
        <source>a universal file (UFF)</source>
        <translation>plik uniwersalny (UFF)</translation>
    </message>
    <message>
        <source>an NC program</source>
        <translation>program NC</translation>
    </message>
    <message>
        <source>a text document</source>
        <translation>dokument tekstowy</translation>
    </message>
    <message>
        <source>nothing but zero bytes to the end</source>
        <translation>same bajty zerowe aż do końca</translation>
    </message>
    <message>
        <source>the source text of a program or JSON</source>
        <translation>tekst źródłowy programu albo JSON</translation>
    </message>
    <message>
        <source>{parameter} would overwrite {file}, which is an input. Name another file.</source>
        <translation>{parameter} zastąpiłby plik {file}, który jest danymi wejściowymi. Podaj inny plik.</translation>
    </message>
    <message>
        <source>{parameter}: {file} is named for two outputs, also as {other}.</source>
        <translation>{parameter}: plik {file} podano dla dwóch wyjść, także jako {other}.</translation>
    </message>
    <message>
        <source>Several columns may be meant: found “{found}”, where {candidates} could each be {meaning}.</source>
        <translation>Może chodzić o kilka kolumn: w „{found}” każda z {candidates} może oznaczać {meaning}.</translation>
    </message>
    <message>
        <source>This folder holds no reference data: found {found}, expected {expected}.</source>
        <translation>Ten folder nie zawiera danych wzorcowych: znaleziono {found}, oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>{path}: columns read: {columns}.</source>
        <translation>{path}: odczytane kolumny: {columns}.</translation>
    </message>
    <message>
        <source>ply</source>
        <translation>ply</translation>
    </message>
    <message>
        <source>the angle</source>
        <translation>kąt</translation>
    </message>
    <message>
        <source>the deviation</source>
        <translation>odchyłkę</translation>
    </message>
    <message>
        <source>the radius</source>
        <translation>promień</translation>
    </message>
    <message>
        <source>x or y</source>
        <translation>x lub y</translation>
    </message>
    <message>
        <source>the angle or the radius</source>
        <translation>kąt lub promień</translation>
    </message>
    <message>
        <source>further bytes behind the last element</source>
        <translation>kolejne bajty za ostatnim elementem</translation>
    </message>
    <message>
        <source>points as text</source>
        <translation>punkty zapisane jako tekst</translation>
    </message>
    <message>
        <source>All sets are built in; no folder with further ones was named.</source>
        <translation>Wszystkie zestawy są wbudowane; nie wskazano folderu z dalszymi.</translation>
    </message>
    <message>
        <source>The sections span {length_mm} mm of a workpiece of {diameter_mm} mm: too short for an axis, so there is no cylindricity.</source>
        <translation>Przekroje obejmują {length_mm} mm przedmiotu o średnicy {diameter_mm} mm: za mało na oś, więc walcowości nie ma.</translation>
    </message>
    <message>
        <source>Sections whose form is not measured: {count}. In section {section} RONt is {RONt_um} µm with an uncertainty of {expanded_uncertainty_um} µm: noise, drift or hum, not form. They are not judged.</source>
        <translation>Przekroje, których kształt nie został zmierzony: {count}. W przekroju {section} RONt wynosi {RONt_um} µm przy niepewności {expanded_uncertainty_um} µm: to szum, dryft lub przydźwięk, nie kształt. Nie są oceniane.</translation>
    </message>
    <message>
        <source>the name of a file; only --json writes to standard output</source>
        <translation>nazwa pliku; na standardowe wyjście pisze tylko --json</translation>
    </message>
    <message>
        <source>Reference data</source>
        <translation>Dane wzorcowe</translation>
    </message>
    <message>
        <source>Folder with NIST&apos;s circle sets (.ds, .fit), refitted beside the built-in ones.</source>
        <translation>Folder z zestawami okręgów NIST (.ds, .fit), dopasowywanymi ponownie obok wbudowanych.</translation>
    </message>
    <message>
        <source>{path}: facets with two corners in one place, left out: {count}.</source>
        <translation>{path}: pominięte trójkąty z dwoma wierzchołkami w jednym miejscu: {count}.</translation>
    </message>
    <message>
        <source>Points further from the reference are left out; by default 0.6 % of its size or 10 standard deviations.</source>
        <translation>Punkty dalsze od oryginału są pomijane; domyślnie 0,6 % jego wielkości lub 10 odchyleń standardowych.</translation>
    </message>
    <message>
        <source>The {role} shows {coverage_deg}° of the circle; at least {minimum_deg}° are needed for an axis.</source>
        <translation>Skan ({role}) obejmuje {coverage_deg}° okręgu; do wyznaczenia osi potrzeba co najmniej {minimum_deg}°.</translation>
    </message>
    <message>
        <source>Facets of the reference that run round the other way than their neighbours, turned: {count}.</source>
        <translation>Odwrócone trójkąty oryginału, obiegane inaczej niż sąsiednie: {count}.</translation>
    </message>
    <message>
        <source>Small holes of the reference&apos;s mesh, filled: {count}, up to {largest_mm} mm wide.</source>
        <translation>Wypełnione małe otwory siatki oryginału: {count}, o szerokości do {largest_mm} mm.</translation>
    </message>
    <message>
        <source>The mesh of the {role} is coarse: its facets lie up to {sagitta_mm} mm inside the round surface.</source>
        <translation>Siatka ({role}) jest zgrubna: jej trójkąty leżą do {sagitta_mm} mm wewnątrz okrągłej powierzchni.</translation>
    </message>
    <message>
        <source>The {role} shows {coverage_deg}° of the circle, less than half: out-of-roundness passes for a shift.</source>
        <translation>Skan ({role}) obejmuje {coverage_deg}° okręgu, mniej niż połowę: odchyłka okrągłości może udawać przesunięcie.</translation>
    </message>
    <message>
        <source>The {role} is bent: its centre line bows by {bow_mm} ± {bow_uncertainty_mm} mm. The axis runs straight through the section centres.</source>
        <translation>Część ({role}) jest wygięta: jej linia środkowa ma strzałkę {bow_mm} ± {bow_uncertainty_mm} mm. Oś biegnie prosto przez środki przekrojów.</translation>
    </message>
    <message>
        <source>it is flat</source>
        <translation>jest płaski</translation>
    </message>
    <message>
        <source>there are several parts</source>
        <translation>zawiera kilka części</translation>
    </message>
    <message>
        <source>no single axis fits</source>
        <translation>nie pasuje żadna pojedyncza oś</translation>
    </message>
    <message>
        <source>it is bent</source>
        <translation>jest wygięty</translation>
    </message>
    <message>
        <source>too little of the circle is there</source>
        <translation>widać zbyt małą część okręgu</translation>
    </message>
    <message>
        <source>the points lie on a line</source>
        <translation>punkty leżą na prostej</translation>
    </message>
    <message>
        <source>its sections are not round</source>
        <translation>jego przekroje nie są okrągłe</translation>
    </message>
    <message>
        <source>The {role} is not a body of revolution: {why} (residual {residual_mm} mm).</source>
        <translation>Skan ({role}) nie jest bryłą obrotową: {why} (reszta {residual_mm} mm).</translation>
    </message>
    <message>
        <source>The points go round {revolutions} times: the revolutions lie over each other and were evaluated as one profile, their differences as noise.</source>
        <translation>Punkty obiegają okrąg {revolutions} razy: obroty nakładają się i zostały ocenione jako jeden profil, a ich różnice jako szum.</translation>
    </message>
    <message>
        <source>The file has {found_MiB} MiB; the memory that is free allows for {maximum_MiB} MiB.</source>
        <translation>Plik ma {found_MiB} MiB; wolna pamięć pozwala na {maximum_MiB} MiB.</translation>
    </message>
    <message>
        <source>Another program changed the file while it was read. Read it again when it is complete.</source>
        <translation>Inny program zmienił plik podczas odczytu. Proszę wczytać go ponownie, gdy będzie kompletny.</translation>
    </message>
    <message>
        <source>fewer members</source>
        <translation>mniej elementów</translation>
    </message>
    <message>
        <source>a shorter list</source>
        <translation>krótsza lista</translation>
    </message>
    <message>
        <source>No answer: {input} is missing.</source>
        <translation>Brak wyniku: nie podano danych „{input}”.</translation>
    </message>
    <message>
        <source>No answer: {reason}</source>
        <translation>Brak wyniku: {reason}</translation>
    </message>
    <message>
        <source>No answer: the computation was stopped.</source>
        <translation>Brak wyniku: obliczenia zatrzymano.</translation>
    </message>
    <message>
        <source>Probe record or profile</source>
        <translation>Zapis czujników lub profil</translation>
    </message>
    <message>
        <source>The file is no longer the one that was read: SHA-256 was {read}…, is {now}…. Compute again (F5) to take the new file.</source>
        <translation>Plik nie jest już tym, który odczytano: SHA-256 było {read}…, jest {now}…. Aby przyjąć nowy plik, proszę przeliczyć ponownie (F5).</translation>
    </message>
    <message>
        <source>{path} was changed after it was read: SHA-256 was {read}…, is {now}…. This answer is of the file as it was; compute again (F5) to take the new one.</source>
        <translation>{path} zmieniono po odczycie: SHA-256 było {read}…, jest {now}…. Wynik dotyczy pliku sprzed zmiany; aby przyjąć nowy, proszę przeliczyć ponownie (F5).</translation>
    </message>
    <message>
        <source>{path} is no longer there. This answer is of the file as it was, SHA-256 {read}….</source>
        <translation>Pliku {path} już nie ma. Wynik dotyczy pliku, jaki był, SHA-256 {read}….</translation>
    </message>
    <message>
        <source>a list of rows</source>
        <translation>lista wierszy</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Its name.</source>
        <translation>Jego nazwa.</translation>
    </message>
    <message>
        <source>Elastic modulus</source>
        <translation>Moduł sprężystości</translation>
    </message>
    <message>
        <source>Young&apos;s modulus E.</source>
        <translation>Moduł Younga E.</translation>
    </message>
    <message>
        <source>MPa</source>
        <translation>MPa</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Liczba Poissona</translation>
    </message>
    <message>
        <source>Lateral by axial strain.</source>
        <translation>Odkształcenie poprzeczne do wzdłużnego.</translation>
    </message>
    <message>
        <source>Density</source>
        <translation>Gęstość</translation>
    </message>
    <message>
        <source>Mass by volume.</source>
        <translation>Masa na objętość.</translation>
    </message>
    <message>
        <source>kg/m³</source>
        <translation>kg/m³</translation>
    </message>
    <message>
        <source>Loss factor</source>
        <translation>Współczynnik strat</translation>
    </message>
    <message>
        <source>Structural damping: the modulus is E (1 + iη).</source>
        <translation>Tłumienie konstrukcyjne: moduł wynosi E (1 + iη).</translation>
    </message>
    <message>
        <source>Along the axis.</source>
        <translation>Wzdłuż osi.</translation>
    </message>
    <message>
        <source>Start ⌀</source>
        <translation>⌀ początku</translation>
    </message>
    <message>
        <source>At its end toward the free end.</source>
        <translation>Na końcu od strony wolnego końca.</translation>
    </message>
    <message>
        <source>End ⌀</source>
        <translation>⌀ końca</translation>
    </message>
    <message>
        <source>At its end toward the chuck.</source>
        <translation>Na końcu od strony uchwytu.</translation>
    </message>
    <message>
        <source>Bore ⌀</source>
        <translation>⌀ otworu</translation>
    </message>
    <message>
        <source>0: solid.</source>
        <translation>0: pełny.</translation>
    </message>
    <message>
        <source>Arc radius</source>
        <translation>Promień łuku</translation>
    </message>
    <message>
        <source>Positive: convex, negative: concave, empty: straight.</source>
        <translation>Dodatni: wypukły, ujemny: wklęsły, pusty: prosty.</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rola</translation>
    </message>
    <message>
        <source>What it is: chamfer, fillet, groove…</source>
        <translation>Czym jest: fazka, zaokrąglenie, rowek…</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Of the part.</source>
        <translation>Części.</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>Odcinki</translation>
    </message>
    <message>
        <source>From the free end toward the chuck.</source>
        <translation>Od wolnego końca w stronę uchwytu.</translation>
    </message>
    <message>
        <source>Stated for this part.</source>
        <translation>Podany dla tej części.</translation>
    </message>
    <message>
        <source>direction y</source>
        <translation>kierunek y</translation>
    </message>
    <message>
        <source>direction z</source>
        <translation>kierunek z</translation>
    </message>
    <message>
        <source>inner radius</source>
        <translation>promień wewnętrzny</translation>
    </message>
    <message>
        <source>outer radius</source>
        <translation>promień zewnętrzny</translation>
    </message>
    <message>
        <source>CYLt(LSCY)</source>
        <translation>CYLt(LSCY)</translation>
    </message>
    <message>
        <source>CYLp(LSCY)</source>
        <translation>CYLp(LSCY)</translation>
    </message>
    <message>
        <source>CYLv(LSCY)</source>
        <translation>CYLv(LSCY)</translation>
    </message>
    <message>
        <source>CYLq(LSCY)</source>
        <translation>CYLq(LSCY)</translation>
    </message>
    <message>
        <source>CYLt(MZCY)</source>
        <translation>CYLt(MZCY)</translation>
    </message>
    <message>
        <source>RONt</source>
        <translation>RONt</translation>
    </message>
    <message>
        <source>centre x</source>
        <translation>środek x</translation>
    </message>
    <message>
        <source>centre y</source>
        <translation>środek y</translation>
    </message>
    <message>
        <source>proved to</source>
        <translation>potwierdzono do</translation>
    </message>
    <message>
        <source>RONt(MZCI)</source>
        <translation>RONt(MZCI)</translation>
    </message>
    <message>
        <source>RONt(LSCI)</source>
        <translation>RONt(LSCI)</translation>
    </message>
    <message>
        <source>RONt(MICI)</source>
        <translation>RONt(MICI)</translation>
    </message>
    <message>
        <source>RONt(MCCI)</source>
        <translation>RONt(MCCI)</translation>
    </message>
    <message>
        <source>Roundness plot</source>
        <translation>Wykres okrągłości</translation>
    </message>
    <message>
        <source>Harmonic content</source>
        <translation>Zawartość harmonicznych</translation>
    </message>
    <message>
        <source>Measurement uncertainty</source>
        <translation>Niepewność pomiaru</translation>
    </message>
    <message>
        <source>a point cloud or a mesh</source>
        <translation>chmura punktów albo siatka</translation>
    </message>
    <message>
        <source>a table of a profile</source>
        <translation>tabela profilu</translation>
    </message>
    <message>
        <source>Q-DAS characteristics</source>
        <translation>Cechy Q-DAS</translation>
    </message>
    <message>
        <source>The key {key} is missing; expected {expected}.</source>
        <translation>Brak klucza {key}; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>{key} is {found}; expected a value from {minimum} to {maximum}.</source>
        <translation>{key} wynosi {found}; oczekiwano wartości od {minimum} do {maximum}.</translation>
    </message>
    <message>
        <source>a number, a text, true, false, null or a list</source>
        <translation>liczba, tekst, true, false, null albo lista</translation>
    </message>
    <message>
        <source>Deviation map</source>
        <translation>Mapa odchyłek</translation>
    </message>
    <message>
        <source>A mesh laid on itself</source>
        <translation>Siatka nałożona na siebie</translation>
    </message>
    <message>
        <source>A collar with known oversize</source>
        <translation>Kołnierz o znanym naddatku</translation>
    </message>
    <message>
        <source>Revolutions</source>
        <translation>Obroty</translation>
    </message>
    <message>
        <source>Diameter (LSCI)</source>
        <translation>Średnica (LSCI)</translation>
    </message>
    <message>
        <source>Undulations per revolution</source>
        <translation>Liczba fal na obrót</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplituda</translation>
    </message>
    <message>
        <source>cut-off {upr} UPR</source>
        <translation>granica {upr} UPR</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Kąt</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Odchyłka</translation>
    </message>
    <message>
        <source>Along the axis, from the first data</source>
        <translation>Wzdłuż osi, od początku danych</translation>
    </message>
    <message>
        <source>Angle about the axis</source>
        <translation>Kąt wokół osi</translation>
    </message>
    <message>
        <source>error drawn × {factor}</source>
        <translation>błąd powiększony × {factor}</translation>
    </message>
    <message>
        <source>excess</source>
        <translation>naddatek</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>copy</source>
        <translation>kopia</translation>
    </message>
    <message>
        <source>too small</source>
        <translation>poniżej</translation>
    </message>
    <message>
        <source>within</source>
        <translation>w tolerancji</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>powyżej</translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation>rozkład normalny</translation>
    </message>
    <message>
        <source>Along the workpiece, from the free end</source>
        <translation>Wzdłuż przedmiotu, od wolnego końca</translation>
    </message>
    <message>
        <source>section {section}</source>
        <translation>przekrój {section}</translation>
    </message>
    <message>
        <source>Radius, deviation from its mean</source>
        <translation>Promień, odchyłka od średniej</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>kąt</translation>
    </message>
    <message>
        <source>Coordinates over the angle</source>
        <translation>Współrzędne według kąta</translation>
    </message>
    <message>
        <source>Angle as recorded</source>
        <translation>Kąt jak w zapisie</translation>
    </message>
    <message>
        <source>Displacement</source>
        <translation>Przemieszczenie</translation>
    </message>
    <message>
        <source>R − mean</source>
        <translation>R − średnia</translation>
    </message>
    <message>
        <source>Deviation from the mean radius</source>
        <translation>Odchyłka od średniego promienia</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>{count} revolution marks</source>
        <translation>znaczniki obrotów: {count}</translation>
    </message>
    <message>
        <source>marks</source>
        <translation>znaczniki</translation>
    </message>
    <message>
        <source>synchronous motion of {probe}</source>
        <translation>ruch synchroniczny {probe}</translation>
    </message>
    <message>
        <source>{filter}</source>
        <translation>{filter}</translation>
    </message>
    <message>
        <source>{filter} · the limit lies within the uncertainty; {within} of {count} methods keep it</source>
        <translation>{filter} · granica leży w przedziale niepewności; zachowuje ją {within} z {count} metod</translation>
    </message>
    <message>
        <source>{filter} · within by all {count} methods</source>
        <translation>{filter} · w granicy według wszystkich {count} metod</translation>
    </message>
    <message>
        <source>{filter} · above by all {count} methods</source>
        <translation>{filter} · powyżej granicy według wszystkich {count} metod</translation>
    </message>
    <message>
        <source>{filter} · within by {within} of {count} methods: look at the filter</source>
        <translation>{filter} · w granicy według {within} z {count} metod: sprawdź filtr</translation>
    </message>
    <message>
        <source>Largest difference of the profiles</source>
        <translation>Największa różnica profili</translation>
    </message>
    <message>
        <source>RMS deviation</source>
        <translation>Odchyłka RMS</translation>
    </message>
    <message>
        <source>{method}</source>
        <translation>{method}</translation>
    </message>
    <message>
        <source>limit ±{limit}</source>
        <translation>granica ±{limit}</translation>
    </message>
    <message>
        <source>limits {lower} … {upper}</source>
        <translation>granice {lower} … {upper}</translation>
    </message>
    <message>
        <source>limit {limit}</source>
        <translation>granica {limit}</translation>
    </message>
    <message>
        <source>at least {limit}</source>
        <translation>co najmniej {limit}</translation>
    </message>
    <message>
        <source>no limit given</source>
        <translation>nie podano granicy</translation>
    </message>
    <message>
        <source>Motion of the workpiece axis</source>
        <translation>Ruch osi przedmiotu</translation>
    </message>
    <message>
        <source>Form not measured: the noise hides it · {filter}</source>
        <translation>Kształtu nie zmierzono: kryje go szum · {filter}</translation>
    </message>
    <message>
        <source>Section {section} of {count} is the worst · {filter}</source>
        <translation>Najgorszy przekrój: {section} z {count} · {filter}</translation>
    </message>
    <message>
        <source>✗ out</source>
        <translation>✗ poza</translation>
    </message>
    <message>
        <source>What the zone is called.</source>
        <translation>Nazwa strefy.</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <source>Along the axis, from the reference&apos;s first data.</source>
        <translation>Wzdłuż osi, od początku danych oryginału.</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Do</translation>
    </message>
    <message>
        <source>Lower limit</source>
        <translation>Dolna granica</translation>
    </message>
    <message>
        <source>Smallest deviation allowed; without both limits the zone is left out.</source>
        <translation>Najmniejsza dopuszczalna odchyłka; strefa bez obu granic jest pomijana.</translation>
    </message>
    <message>
        <source>Upper limit</source>
        <translation>Górna granica</translation>
    </message>
    <message>
        <source>Largest deviation allowed; without both limits the zone is left out.</source>
        <translation>Największa dopuszczalna odchyłka; strefa bez obu granic jest pomijana.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Powierzchnia</translation>
    </message>
    <message>
        <source>Verdict by</source>
        <translation>Ocena według</translation>
    </message>
    <message>
        <source>Surface: local means against the tolerance. Points: the share of points within.</source>
        <translation>Powierzchnia: lokalne średnie wobec tolerancji. Punkty: udział punktów w tolerancji.</translation>
    </message>
    <message>
        <source>Guarded (ISO 14253-1)</source>
        <translation>Z zapasem (ISO 14253-1)</translation>
    </message>
    <message>
        <source>Rule points: share of points that must lie within the tolerance.</source>
        <translation>Reguła punktów: udział punktów, które muszą leżeć w tolerancji.</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Strefy</translation>
    </message>
    <message>
        <source>Limits of their own along the axis, counted from the reference&apos;s first data.</source>
        <translation>Własne granice wzdłuż osi, liczone od początku danych oryginału.</translation>
    </message>
    <message>
        <source>Worst place: mean deviation</source>
        <translation>Najgorsze miejsce: średnia odchyłka</translation>
    </message>
    <message>
        <source>… its uncertainty (95 % for the worst of all places)</source>
        <translation>… jej niepewność (95 % dla najgorszego ze wszystkich miejsc)</translation>
    </message>
    <message>
        <source>… along the axis at</source>
        <translation>… położenie wzdłuż osi</translation>
    </message>
    <message>
        <source>… at the angle</source>
        <translation>… pod kątem</translation>
    </message>
    <message>
        <source>… mean over a square of</source>
        <translation>… średnia z kwadratu o boku</translation>
    </message>
    <message>
        <source>Noise of the points about the surface</source>
        <translation>Szum punktów wokół powierzchni</translation>
    </message>
    <message>
        <source>name</source>
        <translation>nazwa</translation>
    </message>
    <message>
        <source>What differs</source>
        <translation>Co się różni</translation>
    </message>
    <message>
        <source>Worst local deviation</source>
        <translation>Największa odchyłka lokalna</translation>
    </message>
    <message>
        <source>The scan does not decide on ±{limit_mm} mm everywhere: means over {cell_mm} mm are uncertain by {uncertainty_mm} mm. {times} times as many points would, or limits of ±{uncertainty_mm} mm.</source>
        <translation>Skan nie wszędzie pozwala rozstrzygnąć o ±{limit_mm} mm: niepewność średnich z {cell_mm} mm wynosi {uncertainty_mm} mm. Wystarczyłoby {times} razy więcej punktów albo granice ±{uncertainty_mm} mm.</translation>
    </message>
    <message>
        <source>No part of the surface is smooth and dense enough for local means: the verdict is open.</source>
        <translation>Żaden fragment powierzchni nie jest dość gładki i gęsty dla lokalnych średnich: ocena pozostaje otwarta.</translation>
    </message>
    <message>
        <source>points: the share within the limits</source>
        <translation>punkty: udział w granicach</translation>
    </message>
    <message>
        <source>surface: local means against the limits</source>
        <translation>powierzchnia: lokalne średnie wobec granic</translation>
    </message>
    <message>
        <source>off by a constant</source>
        <translation>przesunięcie o stałą</translation>
    </message>
    <message>
        <source>taper</source>
        <translation>stożkowość</translation>
    </message>
    <message>
        <source>barrel or hollow</source>
        <translation>baryłkowość lub siodłowość</translation>
    </message>
    <message>
        <source>bump or dent</source>
        <translation>garb lub wgniecenie</translation>
    </message>
    <message>
        <source>no points of the copy</source>
        <translation>brak punktów kopii</translation>
    </message>
    <message>
        <source>an end beyond the zone&apos;s start</source>
        <translation>koniec za początkiem strefy</translation>
    </message>
    <message>
        <source>both limits, or null for both (the zone is left out)</source>
        <translation>obie granice albo obie null (strefa jest pomijana)</translation>
    </message>
    <message>
        <source>a lower limit not above the upper one</source>
        <translation>dolna granica nie większa niż górna</translation>
    </message>
    <message>
        <source>a zone that overlaps no other</source>
        <translation>strefa niezachodząca na inną</translation>
    </message>
    <message>
        <source>an object with name, z_start_mm, z_end_mm, lower_mm, upper_mm</source>
        <translation>obiekt z name, z_start_mm, z_end_mm, lower_mm, upper_mm</translation>
    </message>
    <message>
        <source>Limits of their own along the axis, from FILE.json.</source>
        <translation>Własne granice wzdłuż osi, z pliku FILE.json.</translation>
    </message>
    <message>
        <source>Guarded rejection: out only where surely out. Simple: the value alone. Guarded: only what is sure passes or fails.</source>
        <translation>Odrzucanie z zapasem: poza tylko to, co na pewno poza. Prosta: sama wartość. Z zapasem: tylko to, co pewne, jest dopuszczane lub odrzucane.</translation>
    </message>
    <message>
        <source>Guarded rejection: out only where a local mean surely exceeds the limit, within where none does. Simple: the mean alone. Guarded: only what is sure passes or fails. Rule surface.</source>
        <translation>Odrzucanie z zapasem: poza tylko tam, gdzie średnia lokalna na pewno przekracza granicę, w tolerancji tam, gdzie żadna jej nie przekracza. Prosta: sama średnia. Z zapasem: tylko to, co pewne, jest dopuszczane lub odrzucane. Reguła powierzchni.</translation>
    </message>
    <message>
        <source>guarded rejection: out only where the value less its uncertainty is beyond the limit</source>
        <translation>odrzucanie z zapasem: poza tylko tam, gdzie wartość zmniejszona o niepewność przekracza granicę</translation>
    </message>
    <message>
        <source>Guarded rejection</source>
        <translation>Odrzucanie z zapasem</translation>
    </message>
    <message>
        <source>Noise and spacing of the points hide small defects: one of ±{limit_mm} mm or more that is less than {size_mm} mm across would not be seen everywhere.</source>
        <translation>Szum i odstępy punktów ukrywają małe wady: wady o ±{limit_mm} mm lub więcej i o średnicy poniżej {size_mm} mm nie byłoby widać wszędzie.</translation>
    </message>
    <message>
        <source>Unrolled surface</source>
        <translation>Rozwinięcie powierzchni</translation>
    </message>
    <message>
        <source>Local radius along the axis</source>
        <translation>Promień miejscowy wzdłuż osi</translation>
    </message>
    <message>
        <source>Deviation from the cylinder&apos;s radius</source>
        <translation>Odchyłka od promienia walca</translation>
    </message>
    <message>
        <source>all points</source>
        <translation>wszystkie punkty</translation>
    </message>
    <message>
        <source>local radius</source>
        <translation>promień miejscowy</translation>
    </message>
    <message>
        <source>minimum zone</source>
        <translation>strefa minimalna</translation>
    </message>
    <message>
        <source>Axis of the local circles</source>
        <translation>Oś miejscowych okręgów</translation>
    </message>
    <message>
        <source>Centre, from the cylinder&apos;s axis</source>
        <translation>Środek, od osi walca</translation>
    </message>
    <message>
        <source>from</source>
        <translation>od</translation>
    </message>
    <message>
        <source>to</source>
        <translation>do</translation>
    </message>
    <message>
        <source>value</source>
        <translation>wartość</translation>
    </message>
    <message>
        <source>U</source>
        <translation>U</translation>
    </message>
    <message>
        <source>std. dev.</source>
        <translation>odch. std.</translation>
    </message>
    <message>
        <source>lower</source>
        <translation>dolna</translation>
    </message>
    <message>
        <source>upper</source>
        <translation>górna</translation>
    </message>
    <message>
        <source>through x</source>
        <translation>przez x</translation>
    </message>
    <message>
        <source>diameter</source>
        <translation>średnica</translation>
    </message>
    <message>
        <source>run-out</source>
        <translation>bicie</translation>
    </message>
    <message>
        <source>two-point</source>
        <translation>dwupunktowy</translation>
    </message>
    <message>
        <source>All sections against the tolerance</source>
        <translation>Wszystkie przekroje względem tolerancji</translation>
    </message>
    <message>
        <source>Points of one cylindrical surface: a scan, or sections measured one above the other.</source>
        <translation>Punkty jednej powierzchni walcowej: skan albo przekroje zmierzone jeden nad drugim.</translation>
    </message>
    <message>
        <source>Drop the points of a cylindrical surface here.</source>
        <translation>Upuść tu punkty powierzchni walcowej.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Udział</translation>
    </message>
    <message>
        <source>Date, signature</source>
        <translation>Data, podpis</translation>
    </message>
    <message>
        <source>Company</source>
        <translation>Firma</translation>
    </message>
    <message>
        <source>That measured.</source>
        <translation>Która mierzyła.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Część</translation>
    </message>
    <message>
        <source>What it is called.</source>
        <translation>Jak się nazywa.</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Rysunek</translation>
    </message>
    <message>
        <source>Number and revision of the drawing.</source>
        <translation>Numer i wydanie rysunku.</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Numer seryjny</translation>
    </message>
    <message>
        <source>Of this part, or of its batch.</source>
        <translation>Tej części albo jej partii.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Zlecenie</translation>
    </message>
    <message>
        <source>Number of the order.</source>
        <translation>Numer zlecenia.</translation>
    </message>
    <message>
        <source>Customer</source>
        <translation>Klient</translation>
    </message>
    <message>
        <source>For whom it is.</source>
        <translation>Dla kogo jest.</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Przyrząd</translation>
    </message>
    <message>
        <source>What measured, with its number.</source>
        <translation>Czym mierzono, z numerem.</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Wzorcowano</translation>
    </message>
    <message>
        <source>Date of the instrument&apos;s calibration, as its certificate states it.</source>
        <translation>Data wzorcowania przyrządu, jak podaje świadectwo.</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Kontroler</translation>
    </message>
    <message>
        <source>Who measured and evaluated.</source>
        <translation>Kto mierzył i oceniał.</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Whatever else belongs on the first page.</source>
        <translation>Co jeszcze należy na pierwszą stronę.</translation>
    </message>
    <message>
        <source>{path}: the sensitivity of the probes is not given; assumed {sensitivity_um_per_V} µm/V. Every length in the result follows from it.</source>
        <translation>{path}: nie podano czułości czujników; przyjęto {sensitivity_um_per_V} µm/V. Zależy od niej każda długość w wyniku.</translation>
    </message>
    <message>
        <source>Of displacement channels recorded in volts; others need none. Not given: 50 is assumed.</source>
        <translation>Kanałów przemieszczeń zapisanych w woltach; inne jej nie wymagają. Gdy nie podano, przyjmuje się 50.</translation>
    </message>
    <message>
        <source>The project has no “{item}” of the kind {kind}: keep it again, or choose a file.</source>
        <translation>Projekt nie ma „{item}” rodzaju {kind}: zachowaj to ponownie albo wybierz plik.</translation>
    </message>
    <message>
        <source>oval</source>
        <translation>owal</translation>
    </message>
    <message>
        <source>three-jaw chuck?</source>
        <translation>uchwyt trójszczękowy?</translation>
    </message>
    <message>
        <source>four-jaw chuck?</source>
        <translation>uchwyt czteroszczękowy?</translation>
    </message>
    <message>
        <source>five lobes</source>
        <translation>pięć garbów</translation>
    </message>
    <message>
        <source>six lobes</source>
        <translation>sześć garbów</translation>
    </message>
    <message>
        <source>bearing or drive?</source>
        <translation>łożysko lub napęd?</translation>
    </message>
    <message>
        <source>vibration?</source>
        <translation>drgania?</translation>
    </message>
    <message>
        <source>chatter or feed?</source>
        <translation>drgania samowzbudne lub posuw?</translation>
    </message>
    <message>
        <source>Profile and reference circle</source>
        <translation>Profil i okrąg odniesienia</translation>
    </message>
    <message>
        <source>zone</source>
        <translation>strefa</translation>
    </message>
    <message>
        <source>Averaging the deviation locally</source>
        <translation>Lokalne uśrednianie odchyłki</translation>
    </message>
    <message>
        <source>Copies of the same original</source>
        <translation>Kopie tego samego oryginału</translation>
    </message>
    <message>
        <source>Trend of the copies</source>
        <translation>Przebieg kopii</translation>
    </message>
    <message>
        <source>Number of the copy</source>
        <translation>Numer kopii</translation>
    </message>
    <message>
        <source>worst local deviation</source>
        <translation>najgorsza lokalna odchyłka</translation>
    </message>
    <message>
        <source>± U (k = 2)</source>
        <translation>± U (k = 2)</translation>
    </message>
    <message>
        <source>Further copies</source>
        <translation>Dalsze kopie</translation>
    </message>
    <message>
        <source>Scans of more parts, judged by the same limits: table and trend</source>
        <translation>Skany kolejnych części, ocenianych według tych samych granic: tabela i przebieg</translation>
    </message>
    <message>
        <source>Reference and copy are the same points in the same order: the surfaces differ nowhere, and nothing was measured.</source>
        <translation>Oryginał i kopia to te same punkty w tej samej kolejności: powierzchnie nigdzie się nie różnią i niczego nie zmierzono.</translation>
    </message>
    <message>
        <source>assumed: {values}</source>
        <translation>założono: {values}</translation>
    </message>
    <message>
        <source>{value} (from the file)</source>
        <translation>{value} (z pliku)</translation>
    </message>
    <message>
        <source>{value} (assumed)</source>
        <translation>{value} (założono)</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Of the company, on the first page.</source>
        <translation>Firmy, na pierwszej stronie.</translation>
    </message>
    <message>
        <source>each probe once</source>
        <translation>każdej sondy jeden raz</translation>
    </message>
    <message>
        <source>X3</source>
        <translation>X3</translation>
    </message>
    <message>
        <source>Y3</source>
        <translation>Y3</translation>
    </message>
    <message>
        <source>Xp</source>
        <translation>Xp</translation>
    </message>
    <message>
        <source>Yp</source>
        <translation>Yp</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source>The signal that it gives.</source>
        <translation>Sygnał, który daje.</translation>
    </message>
    <message>
        <source>By its calibration certificate.</source>
        <translation>Według jej świadectwa wzorcowania.</translation>
    </message>
    <message>
        <source>Date of the calibration, for the report.</source>
        <translation>Data wzorcowania, do raportu.</translation>
    </message>
    <message>
        <source>Calibration of single probes</source>
        <translation>Wzorcowanie poszczególnych sond</translation>
    </message>
    <message>
        <source>Where probes differ: signal, sensitivity, date of the calibration; X3,49.8,2026-01-31;Y3,50.2.</source>
        <translation>Gdy sondy się różnią: sygnał, czułość, data wzorcowania; X3,49.8,2026-01-31;Y3,50.2.</translation>
    </message>
    <message>
        <source>a picture</source>
        <translation>obrazu</translation>
    </message>
    <message>
        <source>The shaft has no segment that is longer than 0.</source>
        <translation>Wał nie ma odcinka dłuższego niż 0.</translation>
    </message>
    <message>
        <source>Segment {segment} of the shaft: {quantity} is {found_mm} mm; expected {expected}.</source>
        <translation>Odcinek {segment} wału: {quantity} wynosi {found_mm} mm; oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>The place z = {z_mm} mm is not on the shaft; expected 0 to {length_mm} mm.</source>
        <translation>Miejsce z = {z_mm} mm nie leży na wale; oczekiwano od 0 do {length_mm} mm.</translation>
    </message>
    <message>
        <source>more than 0</source>
        <translation>więcej niż 0</translation>
    </message>
    <message>
        <source>the bore</source>
        <translation>otwór</translation>
    </message>
    <message>
        <source>less than the outer diameter</source>
        <translation>mniej niż średnica zewnętrzna</translation>
    </message>
    <message>
        <source>the length</source>
        <translation>długość</translation>
    </message>
    <message>
        <source>0 or more</source>
        <translation>0 lub więcej</translation>
    </message>
    <message>
        <source>the start diameter</source>
        <translation>średnica początkowa</translation>
    </message>
    <message>
        <source>the end diameter</source>
        <translation>średnica końcowa</translation>
    </message>
    <message>
        <source>the arc radius</source>
        <translation>promień łuku</translation>
    </message>
    <message>
        <source>at least half the chord</source>
        <translation>co najmniej połowa cięciwy</translation>
    </message>
    <message>
        <source>the diameter of the arc</source>
        <translation>średnica łuku</translation>
    </message>
    <message>
        <source>Frequency responses</source>
        <translation>Charakterystyki częstotliwościowe</translation>
    </message>
    <message>
        <source>A data set declares {expected} points (line {declared_line}) and holds {found}.</source>
        <translation>Zbiór danych deklaruje {expected} punktów (wiersz {declared_line}), a zawiera {found}.</translation>
    </message>
    <message>
        <source>No unit of the frequency response is stated: found “{found}”, expected {expected}. State it.</source>
        <translation>Nie podano jednostki charakterystyki: znaleziono „{found}”, oczekiwano {expected}. Podaj ją.</translation>
    </message>
    <message>
        <source>The file holds no frequency response: found {found}.</source>
        <translation>Plik nie zawiera charakterystyki częstotliwościowej: znaleziono {found}.</translation>
    </message>
    <message>
        <source>The frequencies do not ascend: {found} Hz follows {previous} Hz.</source>
        <translation>Częstotliwości nie rosną: {found} Hz następuje po {previous} Hz.</translation>
    </message>
    <message>
        <source>The variables cannot be told: found {found}, expected {expected}. Name them as f=NAME,H=NAME.</source>
        <translation>Nie można rozpoznać zmiennych: znaleziono {found}, oczekiwano {expected}. Nazwij je jako f=NAZWA,H=NAZWA.</translation>
    </message>
    <message>
        <source>{path}: {count} functions are no frequency responses of a motion ({reason}), the first at line {line}.</source>
        <translation>{path}: funkcji, które nie są charakterystyką ruchu ({reason}): {count}, pierwsza w wierszu {line}.</translation>
    </message>
    <message>
        <source>{path}: “{label}” is stated in {unit}, which is {quantity}; the unit rules ({count} times, first at line {line}).</source>
        <translation>{path}: „{label}” podano w {unit}, czyli {quantity}; obowiązuje jednostka (razy: {count}, pierwszy w wierszu {line}).</translation>
    </message>
    <message>
        <source>{path}: no unit of the force is stated; read as N ({count} times, first at line {line}).</source>
        <translation>{path}: nie podano jednostki siły; przyjęto N (razy: {count}, pierwszy w wierszu {line}).</translation>
    </message>
    <message>
        <source>{path}: the file states {unit}; the given unit {given} is not used ({count} times, first at line {line}).</source>
        <translation>{path}: plik podaje {unit}; podana jednostka {given} nie jest używana (razy: {count}, pierwszy w wierszu {line}).</translation>
    </message>
    <message>
        <source>{path}: the receptance of driving point {node} has a positive imaginary part in {percent} % of its lines; a direction, a unit or the sign of time is stated wrongly ({count} times, first at line {line}).</source>
        <translation>{path}: receptancja punktu wzbudzenia {node} ma dodatnią część urojoną w {percent} % prążków; kierunek, jednostka albo znak czasu są podane błędnie (razy: {count}, pierwszy w wierszu {line}).</translation>
    </message>
    <message>
        <source>{path}: frequency lines without finite values, left out: {lines} ({count} times, first at line {line}).</source>
        <translation>{path}: pominięte prążki bez skończonych wartości: {lines} (razy: {count}, pierwszy w wierszu {line}).</translation>
    </message>
    <message>
        <source>{path}: {count} coherence functions fit the lines of no frequency response, the first at line {line}.</source>
        <translation>{path}: funkcji koherencji niepasujących do prążków żadnej charakterystyki: {count}, pierwsza w wierszu {line}.</translation>
    </message>
    <message>
        <source>{path}: {count} data sets hold more than their declared points, which were read, the first at line {line}.</source>
        <translation>{path}: zbiorów danych zawierających więcej niż zadeklarowane punkty, które odczytano: {count}, pierwszy w wierszu {line}.</translation>
    </message>
    <message>
        <source>no line with finite values</source>
        <translation>żadnego prążka o skończonych wartościach</translation>
    </message>
    <message>
        <source>f=NAME,H=NAME</source>
        <translation>f=NAZWA,H=NAZWA</translation>
    </message>
    <message>
        <source>a real vector of frequencies of the given name</source>
        <translation>rzeczywisty wektor częstotliwości o podanej nazwie</translation>
    </message>
    <message>
        <source>an array of the given name, as long as the frequencies</source>
        <translation>tablica o podanej nazwie, tak długa jak częstotliwości</translation>
    </message>
    <message>
        <source>one vector of frequencies</source>
        <translation>jeden wektor częstotliwości</translation>
    </message>
    <message>
        <source>one complex array as long as frequencies</source>
        <translation>jedna tablica zespolona tak długa jak częstotliwości</translation>
    </message>
    <message>
        <source>a unit; a MAT file states none</source>
        <translation>jednostka; plik MAT jej nie podaje</translation>
    </message>
    <message>
        <source>as stated</source>
        <translation>jak podano</translation>
    </message>
    <message>
        <source>Unit of the response</source>
        <translation>Jednostka charakterystyki</translation>
    </message>
    <message>
        <source>Variables</source>
        <translation>Zmienne</translation>
    </message>
    <message>
        <source>Of a MAT file, where names do not tell: f=NAME,H=NAME.</source>
        <translation>Pliku MAT, gdy nazwy nie wystarczają: f=NAZWA,H=NAZWA.</translation>
    </message>
    <message>
        <source>a table of a frequency response: frequency, real and imaginary part</source>
        <translation>tabela charakterystyki: częstotliwość, część rzeczywista i urojona</translation>
    </message>
    <message>
        <source>a column of a frequency response</source>
        <translation>kolumna charakterystyki częstotliwościowej</translation>
    </message>
    <message>
        <source>bytes of a variable</source>
        <translation>bajty zmiennej</translation>
    </message>
    <message>
        <source>a small data element</source>
        <translation>mały element danych</translation>
    </message>
    <message>
        <source>memory for zlib</source>
        <translation>pamięć dla zlib</translation>
    </message>
    <message>
        <source>data compressed by zlib</source>
        <translation>dane skompresowane przez zlib</translation>
    </message>
    <message>
        <source>flags, dimensions and the name of a variable</source>
        <translation>znaczniki, wymiary i nazwa zmiennej</translation>
    </message>
    <message>
        <source>a type of numbers</source>
        <translation>typ liczb</translation>
    </message>
    <message>
        <source>a matrix</source>
        <translation>macierz</translation>
    </message>
    <message>
        <source>a MAT file of level 5 (MATLAB 5 to 7)</source>
        <translation>plik MAT poziomu 5 (MATLAB 5 do 7)</translation>
    </message>
    <message>
        <source>something else</source>
        <translation>coś innego</translation>
    </message>
    <message>
        <source>a MAT file 7.3 (HDF5); save it with -v7</source>
        <translation>plik MAT 7.3 (HDF5); zapisz go z -v7</translation>
    </message>
    <message>
        <source>a number in its columns</source>
        <translation>liczba w swoich kolumnach</translation>
    </message>
    <message>
        <source>another type of function</source>
        <translation>inny typ funkcji</translation>
    </message>
    <message>
        <source>real values</source>
        <translation>wartości rzeczywiste</translation>
    </message>
    <message>
        <source>no axis of frequency</source>
        <translation>brak osi częstotliwości</translation>
    </message>
    <message>
        <source>a rotation or a moment</source>
        <translation>obrót albo moment</translation>
    </message>
    <message>
        <source>no motion per force by its unit</source>
        <translation>według jednostki nie jest ruchem na siłę</translation>
    </message>
    <message>
        <source>no motion by its kind</source>
        <translation>według rodzaju nie jest ruchem</translation>
    </message>
    <message>
        <source>no points</source>
        <translation>brak punktów</translation>
    </message>
    <message>
        <source>a unit of motion and force for the ordinate, or a set 164</source>
        <translation>jednostka ruchu i siły rzędnej albo zbiór 164</translation>
    </message>
    <message>
        <source>the header of a function</source>
        <translation>nagłówek funkcji</translation>
    </message>
    <message>
        <source>the number of a node</source>
        <translation>numer węzła</translation>
    </message>
    <message>
        <source>2, 4, 5 or 6 for the type of the values</source>
        <translation>2, 4, 5 albo 6 jako typ wartości</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>liczba punktów</translation>
    </message>
    <message>
        <source>0 (uneven) or 1 (even)</source>
        <translation>0 (nierówno) albo 1 (równo)</translation>
    </message>
    <message>
        <source>bytes of a function&apos;s values</source>
        <translation>bajty wartości funkcji</translation>
    </message>
    <message>
        <source>1 (little endian) or 2 (big endian)</source>
        <translation>1 (little endian) albo 2 (big endian)</translation>
    </message>
    <message>
        <source>2 (IEEE 754 numbers)</source>
        <translation>2 (liczby IEEE 754)</translation>
    </message>
    <message>
        <source>a number of header lines, 11</source>
        <translation>liczba wierszy nagłówka, 11</translation>
    </message>
    <message>
        <source>a number of bytes</source>
        <translation>liczba bajtów</translation>
    </message>
    <message>
        <source>a data set between separators: -1 in columns 5 and 6</source>
        <translation>zbiór danych między separatorami: -1 w kolumnach 5 i 6</translation>
    </message>
    <message>
        <source>the number of a data set</source>
        <translation>numer zbioru danych</translation>
    </message>
    <message>
        <source>a separator behind the stated bytes</source>
        <translation>separator za podanymi bajtami</translation>
    </message>
    <message>
        <source>the factors of units, larger than 0</source>
        <translation>współczynniki jednostek większe od 0</translation>
    </message>
    <message>
        <source>the place of a node</source>
        <translation>położenie węzła</translation>
    </message>
    <message>
        <source>no data set</source>
        <translation>żadnego zbioru danych</translation>
    </message>
    <message>
        <source>a MAT file</source>
        <translation>plik MAT</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Wygładzanie</translation>
    </message>
    <message>
        <source>Along frequency, by what each line knows and does not know.</source>
        <translation>Wzdłuż częstotliwości, według tego, co każdy prążek wie, a czego nie.</translation>
    </message>
    <message>
        <source>Hold out rod</source>
        <translation>Pręt odłożony</translation>
    </message>
    <message>
        <source>This rod is not used but predicted; 0: all are used.</source>
        <translation>Ten pręt nie jest używany, lecz przewidywany; 0: używane są wszystkie.</translation>
    </message>
    <message>
        <source>Node</source>
        <translation>Węzeł</translation>
    </message>
    <message>
        <source>Of the point in the file of responses.</source>
        <translation>Punktu w pliku charakterystyk.</translation>
    </message>
    <message>
        <source>From the chuck</source>
        <translation>Od uchwytu</translation>
    </message>
    <message>
        <source>Along the rod.</source>
        <translation>Wzdłuż pręta.</translation>
    </message>
    <message>
        <source>Outside the chuck.</source>
        <translation>Poza uchwytem.</translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation>Średnica</translation>
    </message>
    <message>
        <source>Of the cylinder.</source>
        <translation>Walca.</translation>
    </message>
    <message>
        <source>Stated for this rod.</source>
        <translation>Podany dla tego pręta.</translation>
    </message>
    <message>
        <source>Where the rod is tapped and measured.</source>
        <translation>Gdzie pręt jest uderzany i mierzony.</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Charakterystyki</translation>
    </message>
    <message>
        <source>File of the frequency responses.</source>
        <translation>Plik charakterystyk częstotliwościowych.</translation>
    </message>
    <message>
        <source>Rods</source>
        <translation>Pręty</translation>
    </message>
    <message>
        <source>Measured in the chuck, one after the other.</source>
        <translation>Mierzone w uchwycie, jeden po drugim.</translation>
    </message>
    <message>
        <source>Magnitude of the receptance</source>
        <translation>Amplituda receptancji</translation>
    </message>
    <message>
        <source>Frequency</source>
        <translation>Częstotliwość</translation>
    </message>
    <message>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Amplituda</translation>
    </message>
    <message>
        <source>mm/N</source>
        <translation>mm/N</translation>
    </message>
    <message>
        <source>Real and imaginary part of the receptance</source>
        <translation>Część rzeczywista i urojona receptancji</translation>
    </message>
    <message>
        <source>Receptance</source>
        <translation>Receptancja</translation>
    </message>
    <message>
        <source>µm/N</source>
        <translation>µm/N</translation>
    </message>
    <message>
        <source>real part</source>
        <translation>część rzeczywista</translation>
    </message>
    <message>
        <source>imaginary part</source>
        <translation>część urojona</translation>
    </message>
    <message>
        <source>least real part, {frequency} Hz</source>
        <translation>najmniejsza część rzeczywista, {frequency} Hz</translation>
    </message>
    <message>
        <source>The spindle is not known at {frequency_hz} Hz, only from {from_hz} to {to_hz} Hz.</source>
        <translation>Wrzeciono nie jest znane przy {frequency_hz} Hz, tylko od {from_hz} do {to_hz} Hz.</translation>
    </message>
    <message>
        <source>The shaft states bores in its segments and in a list of bores; one of the two is allowed.</source>
        <translation>Wał podaje otwory w odcinkach i na liście otworów; dozwolone jest jedno z dwojga.</translation>
    </message>
    <message>
        <source>{points} points with {frfs} frequency responses are too few for the spindle; at least 2 points and 3 responses are needed.</source>
        <translation>Punktów: {points}, charakterystyk: {frfs}; to za mało dla wrzeciona: potrzeba co najmniej 2 punktów i 3 charakterystyk.</translation>
    </message>
    <message>
        <source>Rod {rod}, point {point}: {distance_mm} mm from the chuck; expected 0 to {length_mm} mm, the rod&apos;s length.</source>
        <translation>Pręt {rod}, punkt {point}: {distance_mm} mm od uchwytu; oczekiwano od 0 do {length_mm} mm, długości pręta.</translation>
    </message>
    <message>
        <source>A frequency response belongs to rod {rod}, points {first} and {second}, which are not stated.</source>
        <translation>Charakterystyka należy do pręta {rod}, punktów {first} i {second}, których nie podano.</translation>
    </message>
    <message>
        <source>Rod {rod}: no frequency response with the node {node} is in the file.</source>
        <translation>Pręt {rod}: w pliku nie ma charakterystyki z węzłem {node}.</translation>
    </message>
    <message>
        <source>The frequency responses have different lines: {first}, {second}.</source>
        <translation>Charakterystyki mają różne prążki: {first}, {second}.</translation>
    </message>
    <message>
        <source>Rod {rod} cannot be held out; there are {rods} rods.</source>
        <translation>Pręta {rod} nie można odłożyć; prętów jest {rods}.</translation>
    </message>
    <message>
        <source>No material is stated; steel is assumed (E {elastic_modulus_MPa} MPa, ρ {density_kg_m3} kg/m³).</source>
        <translation>Nie podano materiału; założono stal (E {elastic_modulus_MPa} MPa, ρ {density_kg_m3} kg/m³).</translation>
    </message>
    <message>
        <source>The spindle is a table of receptances: natural frequencies do not follow from it.</source>
        <translation>Wrzeciono jest tabelą receptancji: częstotliwości własne z niej nie wynikają.</translation>
    </message>
    <message>
        <source>At {lines} of {all} frequencies the measurements hardly tell the three receptances apart (condition number above {limit}).</source>
        <translation>Przy {lines} z {all} częstotliwości pomiary ledwie rozróżniają trzy receptancje (wskaźnik uwarunkowania powyżej {limit}).</translation>
    </message>
    <message>
        <source>At {lines} of {all} frequencies the fit of the spindle did not converge.</source>
        <translation>Przy {lines} z {all} częstotliwości dopasowanie wrzeciona nie jest zbieżne.</translation>
    </message>
    <message>
        <source>Hutchinson</source>
        <translation>Hutchinson</translation>
    </message>
    <message>
        <source>Cowper</source>
        <translation>Cowper</translation>
    </message>
    <message>
        <source>Shear coefficient</source>
        <translation>Współczynnik ścinania</translation>
    </message>
    <message>
        <source>Hutchinson&apos;s agrees with finite elements in three dimensions to 0.03 %.</source>
        <translation>Współczynnik Hutchinsona zgadza się z elementami skończonymi w trzech wymiarach do 0,03 %.</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Dokładna</translation>
    </message>
    <message>
        <source>Finite elements</source>
        <translation>Elementy skończone</translation>
    </message>
    <message>
        <source>Timoshenko&apos;s beam in closed form, or finite elements as a check.</source>
        <translation>Belka Timoszenki w postaci zamkniętej albo elementy skończone dla sprawdzenia.</translation>
    </message>
    <message>
        <source>Response at z</source>
        <translation>Odpowiedź w z</translation>
    </message>
    <message>
        <source>Where the deflection is, from the free end toward the chuck.</source>
        <translation>Gdzie jest ugięcie, od wolnego końca w stronę uchwytu.</translation>
    </message>
    <message>
        <source>Force at z</source>
        <translation>Siła w z</translation>
    </message>
    <message>
        <source>Where the force acts, from the free end toward the chuck.</source>
        <translation>Gdzie działa siła, od wolnego końca w stronę uchwytu.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Krok</translation>
    </message>
    <message>
        <source>From one frequency to the next.</source>
        <translation>Od jednej częstotliwości do następnej.</translation>
    </message>
    <message>
        <source>Step correction</source>
        <translation>Poprawka stopni</translation>
    </message>
    <message>
        <source>Beside a shoulder only material within 45° of the smaller diameter gives stiffness.</source>
        <translation>Obok odsadzenia sztywność daje tylko materiał w granicach 45° od mniejszej średnicy.</translation>
    </message>
    <message>
        <source>Natural frequencies</source>
        <translation>Częstotliwości własne</translation>
    </message>
    <message>
        <source>Natural frequencies, undamped</source>
        <translation>Częstotliwości własne, bez tłumienia</translation>
    </message>
    <message>
        <source>mode</source>
        <translation>postać</translation>
    </message>
    <message>
        <source>frequency (Hz)</source>
        <translation>częstotliwość (Hz)</translation>
    </message>
    <message>
        <source>Condition of each line</source>
        <translation>Uwarunkowanie każdego prążka</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Uwarunkowanie</translation>
    </message>
    <message>
        <source>First natural frequency</source>
        <translation>Pierwsza częstotliwość własna</translation>
    </message>
    <message>
        <source>Largest receptance {magnitude} nm/N at {frequency} Hz · lines: {lines}</source>
        <translation>Największa receptancja {magnitude} nm/N przy {frequency} Hz · prążki: {lines}</translation>
    </message>
    <message>
        <source>Residual of the identification</source>
        <translation>Reszta identyfikacji</translation>
    </message>
    <message>
        <source>Of the rod held out {held_out} % · responses: {responses} · lines: {lines}</source>
        <translation>Pręta odłożonego {held_out} % · charakterystyki: {responses} · prążki: {lines}</translation>
    </message>
    <message>
        <source>Responses: {responses} · lines: {lines}</source>
        <translation>Charakterystyki: {responses} · prążki: {lines}</translation>
    </message>
    <message>
        <source>Frequency response of a shaft</source>
        <translation>Charakterystyka częstotliwościowa wału</translation>
    </message>
    <message>
        <source>Frequency response</source>
        <translation>Charakterystyka częstotliwościowa</translation>
    </message>
    <message>
        <source>Timoshenko&apos;s beam with shear and rotary inertia in closed form, piece by piece; on a spindle joined at the chuck face by receptance coupling.</source>
        <translation>Belka Timoszenki ze ścinaniem i bezwładnością obrotową w postaci zamkniętej, odcinek po odcinku; na wrzecionie połączona w czole uchwytu przez sprzęganie receptancji.</translation>
    </message>
    <message>
        <source>Receptance of a spindle</source>
        <translation>Receptancja wrzeciona</translation>
    </message>
    <message>
        <source>Receptance of the chuck face</source>
        <translation>Receptancja czoła uchwytu</translation>
    </message>
    <message>
        <source>H: deflection per force</source>
        <translation>H: ugięcie na siłę</translation>
    </message>
    <message>
        <source>Inverse receptance coupling line by line: a linear start from the motion of the joint, then weighted least squares on the measured responses.</source>
        <translation>Odwrotne sprzęganie receptancji prążek po prążku: początek liniowy z ruchu połączenia, potem ważone najmniejsze kwadraty na zmierzonych charakterystykach.</translation>
    </message>
    <message>
        <source>“lathelier-shaft”</source>
        <translation>„lathelier-shaft”</translation>
    </message>
    <message>
        <source>version 1</source>
        <translation>wersja 1</translation>
    </message>
    <message>
        <source>outer and bore radius at the start, outer and bore radius at the end, length</source>
        <translation>promień zewnętrzny i otworu na początku, promień zewnętrzny i otworu na końcu, długość</translation>
    </message>
    <message>
        <source>at most 100 000 mm</source>
        <translation>najwyżej 100 000 mm</translation>
    </message>
    <message>
        <source>a number that is 0 or more</source>
        <translation>liczba równa 0 lub większa</translation>
    </message>
    <message>
        <source>a bore radius below the outer radius</source>
        <translation>promień otworu mniejszy od zewnętrznego</translation>
    </message>
    <message>
        <source>not less than the first frequency</source>
        <translation>nie mniej niż pierwsza częstotliwość</translation>
    </message>
    <message>
        <source>at most a million lines</source>
        <translation>najwyżej milion prążków</translation>
    </message>
    <message>
        <source>frequencies that ascend from 0 or more</source>
        <translation>częstotliwości rosnące od 0 lub więcej</translation>
    </message>
    <message>
        <source>at least one frequency</source>
        <translation>co najmniej jedna częstotliwość</translation>
    </message>
    <message>
        <source>a pair [real, imaginary]</source>
        <translation>para [rzeczywista, urojona]</translation>
    </message>
    <message>
        <source>pairs [real, imaginary], one for each frequency</source>
        <translation>pary [rzeczywista, urojona], po jednej na częstotliwość</translation>
    </message>
    <message>
        <source>as many pairs as frequencies</source>
        <translation>tyle par, ile częstotliwości</translation>
    </message>
    <message>
        <source>either springs or a table, not both</source>
        <translation>albo sprężyny, albo tabela, nie oba</translation>
    </message>
    <message>
        <source>springs, or a table by frequency</source>
        <translation>sprężyny albo tabela według częstotliwości</translation>
    </message>
    <message>
        <source>Radial stiffness</source>
        <translation>Sztywność promieniowa</translation>
    </message>
    <message>
        <source>Of the chuck face against deflection.</source>
        <translation>Czoła uchwytu przy ugięciu.</translation>
    </message>
    <message>
        <source>N/mm</source>
        <translation>N/mm</translation>
    </message>
    <message>
        <source>Tilt stiffness</source>
        <translation>Sztywność kątowa</translation>
    </message>
    <message>
        <source>Of the chuck face against rotation.</source>
        <translation>Czoła uchwytu przy obrocie.</translation>
    </message>
    <message>
        <source>N·mm/rad</source>
        <translation>N·mm/rad</translation>
    </message>
    <message>
        <source>Both springs are multiplied by 1 + iη.</source>
        <translation>Obie sprężyny są mnożone przez 1 + iη.</translation>
    </message>
    <message>
        <source>one range of speeds</source>
        <translation>jeden zakres prędkości</translation>
    </message>
    <message>
        <source>One standard deviation; gives the 95 % band of the limit.</source>
        <translation>Jedno odchylenie standardowe; daje pasmo 95 % granicy.</translation>
    </message>
    <message>
        <source>Cutting coefficient K_r</source>
        <translation>Współczynnik skrawania K_r</translation>
    </message>
    <message>
        <source>Force along the chip thickness over its area; without it depths are multiples of the least.</source>
        <translation>Siła wzdłuż grubości wióra na jego pole; bez niego głębokości są wielokrotnościami najmniejszej.</translation>
    </message>
    <message>
        <source>N/mm²</source>
        <translation>N/mm²</translation>
    </message>
    <message>
        <source>As published (N = 60 f/k)</source>
        <translation>Jak opublikowano (N = 60 f/k)</translation>
    </message>
    <message>
        <source>Speed relation</source>
        <translation>Zależność prędkości</translation>
    </message>
    <message>
        <source>Exact keeps the phase of the regeneration; the papers set it to zero.</source>
        <translation>Dokładna zachowuje fazę regeneracji; artykuły przyjmują ją za zero.</translation>
    </message>
    <message>
        <source>Speeds</source>
        <translation>Prędkości</translation>
    </message>
    <message>
        <source>Range that is shown, 1000:4000. Default: the first lobes.</source>
        <translation>Pokazywany zakres, 1000:4000. Domyślnie pierwsze worki.</translation>
    </message>
    <message>
        <source>1/min</source>
        <translation>obr/min</translation>
    </message>
    <message>
        <source>Points of the limit</source>
        <translation>Punkty granicy</translation>
    </message>
    <message>
        <source>Evenly over the speeds.</source>
        <translation>Równo po prędkościach.</translation>
    </message>
    <message>
        <source>Direction factor</source>
        <translation>Współczynnik kierunkowy</translation>
    </message>
    <message>
        <source>By which the receptance is multiplied: how much of a vibration changes the chip thickness.</source>
        <translation>Mnożnik receptancji: ile drgania zmienia grubość wióra.</translation>
    </message>
    <message>
        <source>Uncertainty of the frequencies</source>
        <translation>Niepewność częstotliwości</translation>
    </message>
    <message>
        <source>Uncertainty of the compliance</source>
        <translation>Niepewność podatności</translation>
    </message>
    <message>
        <source>Uncertainty of the cutting coefficient</source>
        <translation>Niepewność współczynnika skrawania</translation>
    </message>
    <message>
        <source>Natural frequency</source>
        <translation>Częstotliwość własna</translation>
    </message>
    <message>
        <source>Undamped.</source>
        <translation>Bez tłumienia.</translation>
    </message>
    <message>
        <source>Damping ratio</source>
        <translation>Tłumienie względne</translation>
    </message>
    <message>
        <source>ζ, of critical damping.</source>
        <translation>ζ, ułamek tłumienia krytycznego.</translation>
    </message>
    <message>
        <source>Modal stiffness</source>
        <translation>Sztywność modalna</translation>
    </message>
    <message>
        <source>Force over displacement at rest.</source>
        <translation>Siła na przemieszczenie w spoczynku.</translation>
    </message>
    <message>
        <source>either a cutting speed or a spindle speed</source>
        <translation>albo prędkość skrawania, albo prędkość wrzeciona</translation>
    </message>
    <message>
        <source>a cutting speed or a spindle speed</source>
        <translation>prędkość skrawania albo prędkość wrzeciona</translation>
    </message>
    <message>
        <source>the diameter for the cutting speed</source>
        <translation>średnica dla prędkości skrawania</translation>
    </message>
    <message>
        <source>one range of cutting speeds</source>
        <translation>jeden zakres prędkości skrawania</translation>
    </message>
    <message>
        <source>a range such as 200:350</source>
        <translation>zakres taki jak 200:350</translation>
    </message>
    <message>
        <source>the diameter for the range</source>
        <translation>średnica dla zakresu</translation>
    </message>
    <message>
        <source>m/min</source>
        <translation>m/min</translation>
    </message>
    <message>
        <source>Of the turned surface.</source>
        <translation>Toczonej powierzchni.</translation>
    </message>
    <message>
        <source>Cutting speed</source>
        <translation>Prędkość skrawania</translation>
    </message>
    <message>
        <source>That is selected.</source>
        <translation>Wybrana.</translation>
    </message>
    <message>
        <source>Spindle speed</source>
        <translation>Prędkość wrzeciona</translation>
    </message>
    <message>
        <source>That is selected, in place of a cutting speed.</source>
        <translation>Wybrana, zamiast prędkości skrawania.</translation>
    </message>
    <message>
        <source>Cutting speeds of the tool</source>
        <translation>Prędkości skrawania narzędzia</translation>
    </message>
    <message>
        <source>Range, 200:350.</source>
        <translation>Zakres, 200:350.</translation>
    </message>
    <message>
        <source>Peak shift P_sh</source>
        <translation>Przesunięcie szczytu P_sh</translation>
    </message>
    <message>
        <source>Place within the lobe, published relation only. Default 0.7.</source>
        <translation>Miejsce w worku, tylko zależność opublikowana. Domyślnie 0,7.</translation>
    </message>
    <message>
        <source>Lobe of the selected speed</source>
        <translation>Worek wybranej prędkości</translation>
    </message>
    <message>
        <source>Nearest in range</source>
        <translation>Najbliższa w zakresie</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>Reguła</translation>
    </message>
    <message>
        <source>Which candidate is recommended.</source>
        <translation>Który kandydat jest zalecany.</translation>
    </message>
    <message>
        <source>Published reproduces the papers; exact takes the robust optimum of the pocket.</source>
        <translation>Opublikowana odtwarza artykuły; dokładna bierze odporne optimum kieszeni.</translation>
    </message>
    <message>
        <source>By which the receptance is multiplied.</source>
        <translation>Mnożnik receptancji.</translation>
    </message>
    <message>
        <source>nothing: the exact relation has its own optimum</source>
        <translation>niczego: zależność dokładna ma własne optimum</translation>
    </message>
    <message>
        <source>nothing chatters: every speed is stable</source>
        <translation>nic nie drga: każda prędkość jest stabilna</translation>
    </message>
    <message>
        <source>it lies above the last lobe, which has no upper neighbour</source>
        <translation>leży powyżej ostatniego worka, który nie ma górnego sąsiada</translation>
    </message>
    <message>
        <source>no candidate lies in the range of cutting speeds</source>
        <translation>żaden kandydat nie leży w zakresie prędkości skrawania</translation>
    </message>
    <message>
        <source>No stable speed can be recommended for {selected_rpm} 1/min: {reason}.</source>
        <translation>Nie można zalecić stabilnej prędkości dla {selected_rpm} obr/min: {reason}.</translation>
    </message>
    <message>
        <source>The frequency response has {found} lines; at least {minimum} are needed.</source>
        <translation>Charakterystyka ma {found} prążków; potrzeba co najmniej {minimum}.</translation>
    </message>
    <message>
        <source>Stability needs a receptance (displacement per force); convert the frequency response first.</source>
        <translation>Stabilność wymaga receptancji (przemieszczenie na siłę); najpierw przelicz charakterystykę.</translation>
    </message>
    <message>
        <source>The real part of the frequency response is nowhere negative: in its range no depth of cut chatters.</source>
        <translation>Część rzeczywista charakterystyki nigdzie nie jest ujemna: w jej zakresie żadna głębokość skrawania nie drga.</translation>
    </message>
    <message>
        <source>The cutting coefficient is not given: depths are multiples of the least limiting depth.</source>
        <translation>Nie podano współczynnika skrawania: głębokości są wielokrotnościami najmniejszej granicznej.</translation>
    </message>
    <message>
        <source>Speeds by N = 60 f/k as published, which sets the phase of the regeneration to zero. It finds the lobes of the papers; depths at a given speed are those of the exact relation only.</source>
        <translation>Prędkości według N = 60 f/k, jak opublikowano, czyli z fazą regeneracji równą zero. Znajduje to worki artykułów; głębokości przy danej prędkości daje tylko zależność dokładna.</translation>
    </message>
    <message>
        <source>The speed of the selected lobe, {lobe_rpm} 1/min, lies outside the range of cutting speeds; recommended is the nearest inside.</source>
        <translation>Prędkość wybranego worka, {lobe_rpm} obr/min, leży poza zakresem prędkości skrawania; zalecana jest najbliższa w zakresie.</translation>
    </message>
    <message>
        <source>The least real part lies at the end of the frequency response, at {frequency_hz} Hz: the mode that limits the depth may lie outside.</source>
        <translation>Najmniejsza część rzeczywista leży na końcu charakterystyki, przy {frequency_hz} Hz: postać ograniczająca głębokość może leżeć poza nią.</translation>
    </message>
    <message>
        <source>Depth of cut, in multiples of the least limit</source>
        <translation>Głębokość / najmniejsza granica</translation>
    </message>
    <message>
        <source>Depth of cut</source>
        <translation>Głębokość skrawania</translation>
    </message>
    <message>
        <source>recommended {speed}</source>
        <translation>zalecana {speed}</translation>
    </message>
    <message>
        <source>selected</source>
        <translation>wybrana</translation>
    </message>
    <message>
        <source>below the tool&apos;s range</source>
        <translation>poniżej zakresu narzędzia</translation>
    </message>
    <message>
        <source>above the tool&apos;s range</source>
        <translation>powyżej zakresu narzędzia</translation>
    </message>
    <message>
        <source>Stability lobes</source>
        <translation>Krzywe workowe</translation>
    </message>
    <message>
        <source>as published</source>
        <translation>jak opublikowano</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabilne</translation>
    </message>
    <message>
        <source>chatter</source>
        <translation>drgania</translation>
    </message>
    <message>
        <source>95 % band</source>
        <translation>pasmo 95 %</translation>
    </message>
    <message>
        <source>operating point</source>
        <translation>punkt pracy</translation>
    </message>
    <message>
        <source>Chatter frequency at the limit</source>
        <translation>Częstotliwość drgań na granicy</translation>
    </message>
    <message>
        <source>Chatter frequency</source>
        <translation>Częstotliwość drgań</translation>
    </message>
    <message>
        <source>Lobe</source>
        <translation>Worek</translation>
    </message>
    <message>
        <source>Stable speed</source>
        <translation>Prędkość stabilna</translation>
    </message>
    <message>
        <source>In the tool&apos;s range</source>
        <translation>W zakresie narzędzia</translation>
    </message>
    <message>
        <source>Frequency of the least real part</source>
        <translation>Częstotliwość najmniejszej części rzeczywistej</translation>
    </message>
    <message>
        <source>Selected speed</source>
        <translation>Prędkość wybrana</translation>
    </message>
    <message>
        <source>Recommended speed</source>
        <translation>Prędkość zalecana</translation>
    </message>
    <message>
        <source>Its cutting speed</source>
        <translation>Jej prędkość skrawania</translation>
    </message>
    <message>
        <source>Its lower end</source>
        <translation>Jego dolny koniec</translation>
    </message>
    <message>
        <source>Its upper end</source>
        <translation>Jego górny koniec</translation>
    </message>
    <message>
        <source>Least limiting depth</source>
        <translation>Najmniejsza głębokość graniczna</translation>
    </message>
    <message>
        <source>Its chatter frequency</source>
        <translation>Jej częstotliwość drgań</translation>
    </message>
    <message>
        <source>Regenerative chatter of a single-point cut: the limiting depth is -1/(2 K_r Re G) of the oriented receptance G; its speeds are 60 f/(k + ε/2π), ε = 3π + 2 arg G, k = 0, 1, 2 …</source>
        <translation>Drgania regeneracyjne przy skrawaniu jednoostrzowym: głębokość graniczna to -1/(2 K_r Re G) zorientowanej receptancji G; jej prędkości to 60 f/(k + ε/2π), ε = 3π + 2 arg G, k = 0, 1, 2 …</translation>
    </message>
    <message>
        <source>Regenerative chatter of a single-point cut by the published relation: the limiting depth is -1/(2 K_r Re G), its speeds are 60 f/k; the phase of the regeneration is set to zero.</source>
        <translation>Drgania regeneracyjne przy skrawaniu jednoostrzowym według zależności opublikowanej: głębokość graniczna to -1/(2 K_r Re G), jej prędkości to 60 f/k; faza regeneracji jest równa zero.</translation>
    </message>
    <message>
        <source>Stable speeds, one for each lobe</source>
        <translation>Prędkości stabilne, jedna dla każdego worka</translation>
    </message>
    <message>
        <source>Depth that is stable at every speed</source>
        <translation>Głębokość stabilna przy każdej prędkości</translation>
    </message>
    <message>
        <source>Nothing chatters: the real part is nowhere negative.</source>
        <translation>Nic nie drga: część rzeczywista nigdzie nie jest ujemna.</translation>
    </message>
    <message>
        <source>Chatter at {frequency} Hz · lobes in the range: {lobes}</source>
        <translation>Drgania przy {frequency} Hz · worki w zakresie: {lobes}</translation>
    </message>
    <message>
        <source>Recommended spindle speed</source>
        <translation>Zalecana prędkość wrzeciona</translation>
    </message>
    <message>
        <source>Instead of {selected} · {cutting_speed} m/min · f_m {frequency} Hz · lobe {k}</source>
        <translation>Zamiast {selected} · {cutting_speed} m/min · f_m {frequency} Hz · worek {k}</translation>
    </message>
    <message>
        <source>Instead of {selected} · f_m {frequency} Hz · lobe {k}</source>
        <translation>Zamiast {selected} · f_m {frequency} Hz · worek {k}</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilność</translation>
    </message>
    <message>
        <source>Stability of cutting</source>
        <translation>Stabilność skrawania</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Krzywe workowe</translation>
    </message>
    <message>
        <source>Spindle speed without chatter</source>
        <translation>Prędkość wrzeciona bez drgań</translation>
    </message>
    <message>
        <source>Of the point that is cut, in the direction of the chip thickness: UFF, CSV or MAT.</source>
        <translation>Skrawanego punktu, w kierunku grubości wióra: UFF, CSV albo MAT.</translation>
    </message>
    <message>
        <source>Drop a frequency response here, or state the modes of the point that is cut.</source>
        <translation>Upuść tu charakterystykę częstotliwościową albo podaj postacie skrawanego punktu.</translation>
    </message>
    <message>
        <source>Finding lobes</source>
        <translation>Szukanie worków</translation>
    </message>
    <message>
        <source>✓ stable</source>
        <translation>✓ stabilne</translation>
    </message>
    <message>
        <source>✗ chatter</source>
        <translation>✗ drgania</translation>
    </message>
    <message>
        <source>{speed} 1/min · no lobe limits here</source>
        <translation>{speed} obr/min · żaden worek tu nie ogranicza</translation>
    </message>
    <message>
        <source>{speed} 1/min · stable with a probability of {probability} % · lobe {k}, chatter at {frequency} Hz</source>
        <translation>{speed} obr/min · stabilne z prawdopodobieństwem {probability} % · worek {k}, drgania przy {frequency} Hz</translation>
    </message>
    <message>
        <source>{speed} 1/min · lobe {k}, chatter at {frequency} Hz</source>
        <translation>{speed} obr/min · worek {k}, drgania przy {frequency} Hz</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Postacie</translation>
    </message>
    <message>
        <source>Of the operating point; drag it in the chart.</source>
        <translation>Punktu pracy; przeciągnij go na wykresie.</translation>
    </message>
    <message>
        <source>Computing</source>
        <translation>Obliczanie</translation>
    </message>
    <message>
        <source>In place of FRF: f_hz,zeta,stiffness_N_mm; several are summed.</source>
        <translation>Zamiast FRF: f_hz,zeta,stiffness_N_mm; kilka jest sumowanych.</translation>
    </message>
    <message>
        <source>Shaft</source>
        <translation>Wał</translation>
    </message>
    <message>
        <source>Of the shaft, from FILE.json.</source>
        <translation>Wału, z FILE.json.</translation>
    </message>
    <message>
        <source>Spindle</source>
        <translation>Wrzeciono</translation>
    </message>
    <message>
        <source>The machine at the chuck face, from FILE.json; without it the shaft is free.</source>
        <translation>Maszyna przy czole uchwytu, z FILE.json; bez niej wał jest swobodny.</translation>
    </message>
    <message>
        <source>Identifying</source>
        <translation>Identyfikacja</translation>
    </message>
    <message>
        <source>computed</source>
        <translation>obliczono</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>zalecenie</translation>
    </message>
    <message>
        <source>CYLt(LSCY) {value_um:2} µm · {points} points</source>
        <translation>CYLt(LSCY) {value_um:2} µm · punktów: {points}</translation>
    </message>
    <message>
        <source>tolerance {tolerance_um} µm</source>
        <translation>tolerancja {tolerance_um} µm</translation>
    </message>
    <message>
        <source>LSCI</source>
        <translation>LSCI</translation>
    </message>
    <message>
        <source>MZCI</source>
        <translation>MZCI</translation>
    </message>
    <message>
        <source>MICI</source>
        <translation>MICI</translation>
    </message>
    <message>
        <source>MCCI</source>
        <translation>MCCI</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>amplituda</translation>
    </message>
    <message>
        <source>{filter} · other methods say {least_um:1} to {most_um:1} µm</source>
        <translation>{filter} · inne metody dają od {least_um:1} do {most_um:1} µm</translation>
    </message>
    <message>
        <source>No filter was chosen: with 1-{upr} UPR {value_um:2} µm</source>
        <translation>Nie wybrano filtru: z 1-{upr} UPR {value_um:2} µm</translation>
    </message>
    <message>
        <source>Points that stand out: {count}; without them {value_um:2} µm</source>
        <translation>Punkty odstające: {count}; bez nich {value_um:2} µm</translation>
    </message>
    <message>
        <source>{upr} UPR, {amplitude_um:2} µm: {meaning}.</source>
        <translation>{upr} UPR, {amplitude_um:2} µm: {meaning}.</translation>
    </message>
    <message>
        <source>mean {mean_um:2} µm</source>
        <translation>średnio {mean_um:2} µm</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>przesunięcie</translation>
    </message>
    <message>
        <source>Step {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Skok {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Taper {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Stożek {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Saddle {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Siodłowość {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Barrel {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Baryłkowość {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Bump {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Wypukłość {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Bump {value_mm:+3} ± {uncertainty_mm:3} mm at X {x_mm:1} Y {y_mm:1} Z {z_mm:1}</source>
        <translation>Wypukłość {value_mm:+3} ± {uncertainty_mm:3} mm w X {x_mm:1} Y {y_mm:1} Z {z_mm:1}</translation>
    </message>
    <message>
        <source>No data of the copy · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Brak danych kopii · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>z&#xa0;{z_mm:1}&#xa0;mm</source>
        <translation>z&#xa0;{z_mm:1}&#xa0;mm</translation>
    </message>
    <message>
        <source>Share of the limits</source>
        <translation>Udział w granicach</translation>
    </message>
    <message>
        <source>Histogram of the shares of the limits</source>
        <translation>Histogram udziałów w granicach</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>granice</translation>
    </message>
    <message>
        <source>z&#xa0;{from_mm:1}-{to_mm:1}&#xa0;mm</source>
        <translation>z&#xa0;{from_mm:1}-{to_mm:1}&#xa0;mm</translation>
    </message>
    <message>
        <source>RMS {rms_mm:4} mm · mean {mean_mm:+4} mm · noise of the scans {scatter_mm:4} mm · {method}</source>
        <translation>RMS {rms_mm:4} mm · średnio {mean_mm:+4} mm · szum skanów {scatter_mm:4} mm · {method}</translation>
    </message>
    <message>
        <source>mean {mean_mm:+4} mm · {method} · {share} % of the points within ±{tolerance_mm} mm</source>
        <translation>średnio {mean_mm:+4} mm · {method} · {share} % punktów w ±{tolerance_mm} mm</translation>
    </message>
    <message>
        <source>mean {mean_mm:+4} mm · {method}</source>
        <translation>średnio {mean_mm:+4} mm · {method}</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>najgorsza</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>szum</translation>
    </message>
    <message>
        <source>1 division = {step_um} µm</source>
        <translation>1 działka = {step_um} µm</translation>
    </message>
    <message>
        <source>Base circle: radius {radius_mm:4} mm</source>
        <translation>Okrąg bazowy: promień {radius_mm:4} mm</translation>
    </message>
    <message>
        <source>barrel {value_um:1} µm on radius</source>
        <translation>baryłkowość {value_um:1} µm na promieniu</translation>
    </message>
    <message>
        <source>saddle {value_um:1} µm on radius</source>
        <translation>siodłowość {value_um:1} µm na promieniu</translation>
    </message>
    <message>
        <source>taper {value_um:1} µm on diameter</source>
        <translation>stożkowość {value_um:1} µm na średnicy</translation>
    </message>
    <message>
        <source>synchronous</source>
        <translation>synchroniczne</translation>
    </message>
    <message>
        <source>asynchronous</source>
        <translation>asynchroniczne</translation>
    </message>
    <message>
        <source>total</source>
        <translation>całkowite</translation>
    </message>
    <message>
        <source>The images of single revolutions have RONt(LSCI) from {least_um:2} to {most_um:2} µm; their mean hides what differs from turn to turn.</source>
        <translation>Obrazy pojedynczych obrotów mają RONt(LSCI) od {least_um:2} do {most_um:2} µm; średnia ukrywa to, co zmienia się z obrotu na obrót.</translation>
    </message>
    <message>
        <source>Repeats with every turn {synchronous_um:1} µm, differs from turn to turn {asynchronous_um:1} µm · {turns} turns · probe X3</source>
        <translation>Powtarzalny w każdym obrocie {synchronous_um:1} µm, zmienny między obrotami {asynchronous_um:1} µm · obrotów: {turns} · czujnik X3</translation>
    </message>
    <message>
        <source>Taper {taper_um:+1} µm on diameter, over the measured length</source>
        <translation>Stożkowatość {taper_um:+1} µm na średnicy, na zmierzonej długości</translation>
    </message>
    <message>
        <source>Saddle {size_um:1} µm on radius</source>
        <translation>Siodłowość {size_um:1} µm na promieniu</translation>
    </message>
    <message>
        <source>Barrel {size_um:1} µm on radius</source>
        <translation>Baryłkowość {size_um:1} µm na promieniu</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>µin</source>
        <translation>µin</translation>
    </message>
    <message>
        <source>Recommended: {speed:0} 1/min, stable up to {limit:3} ×</source>
        <translation>Zalecane: {speed:0} obr/min, stabilne do {limit:3} ×</translation>
    </message>
    <message>
        <source>Recommended: {speed:0} 1/min, stable up to {limit_mm:3+} mm</source>
        <translation>Zalecane: {speed:0} obr/min, stabilne do {limit_mm:3+} mm</translation>
    </message>
    <message>
        <source>Stable at every speed up to {depth_mm:3+} mm</source>
        <translation>Stabilne przy każdej prędkości do {depth_mm:3+} mm</translation>
    </message>
    <message>
        <source>{lines} lines are too many to be kept in a project; at most {maximum} are.</source>
        <translation>Linii jest {lines}, za dużo, by przechować je w projekcie; przechowuje się najwyżej {maximum}.</translation>
    </message>
    <message>
        <source>a receptance</source>
        <translation>receptancja</translation>
    </message>
    <message>
        <source>a mobility</source>
        <translation>mobilność</translation>
    </message>
    <message>
        <source>an accelerance</source>
        <translation>akcelerancja</translation>
    </message>
    <message>
        <source>{found} lines lie between {from_hz} and {to_hz} Hz; a modal fit needs at least {minimum}.</source>
        <translation>Między {from_hz} a {to_hz} Hz linii jest {found}; dopasowanie modalne wymaga co najmniej {minimum}.</translation>
    </message>
    <message>
        <source>Modes are fitted to a receptance (displacement per force); convert the response first.</source>
        <translation>Postacie dopasowuje się do receptancji (przemieszczenie na siłę); najpierw przelicz charakterystykę.</translation>
    </message>
    <message>
        <source>Mode at {frequency_hz} Hz: {lines} lines lie in its half-power band, at least {minimum} are needed to measure its damping. Use a finer frequency resolution.</source>
        <translation>Postać przy {frequency_hz} Hz: w jej paśmie połowy mocy leżą linie w liczbie {lines}, do pomiaru tłumienia potrzeba co najmniej {minimum}. Użyj mniejszego kroku częstotliwości.</translation>
    </message>
    <message>
        <source>Mode at {frequency_hz} Hz has a negative stiffness: force and motion are measured at places that move against each other, or a direction is reversed.</source>
        <translation>Postać przy {frequency_hz} Hz ma ujemną sztywność: siłę i ruch mierzono w miejscach poruszających się przeciwnie albo kierunek jest odwrócony.</translation>
    </message>
    <message>
        <source>Mode at {frequency_hz} Hz is hardly determined by the data (stiffness ± {percent} %): fewer modes describe the response.</source>
        <translation>Postać przy {frequency_hz} Hz jest słabo wyznaczona przez dane (sztywność ± {percent} %): charakterystykę opisuje mniej postaci.</translation>
    </message>
    <message>
        <source>{asked} modes were asked for; the response between {from_hz} and {to_hz} Hz supports {found}.</source>
        <translation>Żądano postaci: {asked}; charakterystyka między {from_hz} a {to_hz} Hz pozwala na {found}.</translation>
    </message>
    <message>
        <source>Between {from_hz} and {to_hz} Hz no mode stands out of the noise.</source>
        <translation>Między {from_hz} a {to_hz} Hz żadna postać nie wyróżnia się z szumu.</translation>
    </message>
    <message>
        <source>A mode outside the fitted range takes part in the fit (near {frequency_hz} Hz); it stands for what lies there and is not measured.</source>
        <translation>W dopasowaniu bierze udział postać spoza zakresu (blisko {frequency_hz} Hz); zastępuje to, co tam leży, i nie jest zmierzona.</translation>
    </message>
    <message>
        <source>The modal fit did not converge; judge it by its error.</source>
        <translation>Dopasowanie modalne nie zbiegło się; oceń je po błędzie.</translation>
    </message>
    <message>
        <source>one range</source>
        <translation>jeden zakres</translation>
    </message>
    <message>
        <source>Number of modes</source>
        <translation>Liczba postaci</translation>
    </message>
    <message>
        <source>Range of frequencies</source>
        <translation>Zakres częstotliwości</translation>
    </message>
    <message>
        <source>Whose lines are fitted, as 100:800; empty: all.</source>
        <translation>Którego linie są dopasowywane, np. 100:800; puste: wszystkie.</translation>
    </message>
    <message>
        <source>Complex residues</source>
        <translation>Residua zespolone</translation>
    </message>
    <message>
        <source>For modes whose places do not move in phase or against each other.</source>
        <translation>Dla postaci, których miejsca nie poruszają się zgodnie ani przeciwnie w fazie.</translation>
    </message>
    <message>
        <source>f</source>
        <translation>f</translation>
    </message>
    <message>
        <source>Natural frequency, undamped.</source>
        <translation>Częstotliwość własna, bez tłumienia.</translation>
    </message>
    <message>
        <source>ζ</source>
        <translation>ζ</translation>
    </message>
    <message>
        <source>Damping ratio, of critical damping.</source>
        <translation>Stopień tłumienia, względem krytycznego.</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>Modal stiffness, force over displacement at rest; negative between places out of phase.</source>
        <translation>Sztywność modalna, siła przez przemieszczenie w spoczynku; ujemna między miejscami w przeciwfazie.</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Faza</translation>
    </message>
    <message>
        <source>Of the residue: 0 for a real normal mode.</source>
        <translation>Residuum: 0 dla rzeczywistej postaci normalnej.</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>zmierzona</translation>
    </message>
    <message>
        <source>modal model, changed by hand</source>
        <translation>model modalny, zmieniony ręcznie</translation>
    </message>
    <message>
        <source>modal model</source>
        <translation>model modalny</translation>
    </message>
    <message>
        <source>{frequency} Hz</source>
        <translation>{frequency} Hz</translation>
    </message>
    <message>
        <source>Phase of the receptance</source>
        <translation>Faza receptancji</translation>
    </message>
    <message>
        <source>Real part of the receptance</source>
        <translation>Część rzeczywista receptancji</translation>
    </message>
    <message>
        <source>Real part</source>
        <translation>Część rzeczywista</translation>
    </message>
    <message>
        <source>Imaginary part of the receptance</source>
        <translation>Część urojona receptancji</translation>
    </message>
    <message>
        <source>Imaginary part</source>
        <translation>Część urojona</translation>
    </message>
    <message>
        <source>Nyquist plot of the receptance</source>
        <translation>Wykres Nyquista receptancji</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Koherencja</translation>
    </message>
    <message>
        <source>Coherence γ²</source>
        <translation>Koherencja γ²</translation>
    </message>
    <message>
        <source>Error of the modal model</source>
        <translation>Błąd modelu modalnego</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Błąd</translation>
    </message>
    <message>
        <source>Rank by flexibility</source>
        <translation>Kolejność według podatności</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>Kolejność</translation>
    </message>
    <message>
        <source>Its standard uncertainty</source>
        <translation>Jej niepewność standardowa</translation>
    </message>
    <message>
        <source>u(f)</source>
        <translation>u(f)</translation>
    </message>
    <message>
        <source>Damping ratio ζ</source>
        <translation>Stopień tłumienia ζ</translation>
    </message>
    <message>
        <source>u(ζ)</source>
        <translation>u(ζ)</translation>
    </message>
    <message>
        <source>u(k)</source>
        <translation>u(k)</translation>
    </message>
    <message>
        <source>Phase of the residue</source>
        <translation>Faza residuum</translation>
    </message>
    <message>
        <source>phase</source>
        <translation>faza</translation>
    </message>
    <message>
        <source>Least real part of this mode, sign reversed</source>
        <translation>Najmniejsza część rzeczywista tej postaci, z odwróconym znakiem</translation>
    </message>
    <message>
        <source>nm/N</source>
        <translation>nm/N</translation>
    </message>
    <message>
        <source>-min Re</source>
        <translation>-min Re</translation>
    </message>
    <message>
        <source>{rank}. {frequency} Hz: {flexibility} nm/N · ζ {damping} %</source>
        <translation>{rank}. {frequency} Hz: {flexibility} nm/N · ζ {damping} %</translation>
    </message>
    <message>
        <source>mm/(N·s²)</source>
        <translation>mm/(N·s²)</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>Reszty</translation>
    </message>
    <message>
        <source>Of modes below, 1/M</source>
        <translation>Postaci poniżej, 1/M</translation>
    </message>
    <message>
        <source>Of modes above, 1/K</source>
        <translation>Postaci powyżej, 1/K</translation>
    </message>
    <message>
        <source>Least real part {real} nm/N · lines: {lines}</source>
        <translation>Najmniejsza część rzeczywista {real} nm/N · linii: {lines}</translation>
    </message>
    <message>
        <source>changed by hand</source>
        <translation>zmienione ręcznie</translation>
    </message>
    <message>
        <source>fitted</source>
        <translation>dopasowane</translation>
    </message>
    <message>
        <source>Dominant mode</source>
        <translation>Postać dominująca</translation>
    </message>
    <message>
        <source>ζ {damping} % · k {stiffness} N/mm · error of the model {error} % (rms) · modes: {modes}</source>
        <translation>ζ {damping} % · k {stiffness} N/mm · błąd modelu {error} % (rms) · postaci: {modes}</translation>
    </message>
    <message>
        <source>Frequency response and its modes</source>
        <translation>Charakterystyka częstotliwościowa i jej postacie</translation>
    </message>
    <message>
        <source>Handbook values of {material} are assumed, not those of this bar (source: {source}).</source>
        <translation>Przyjęto wartości z poradnika dla: {material}, a nie wartości tego pręta (źródło: {source}).</translation>
    </message>
    <message>
        <source>The springs are taken from the library, not from this machine (source: {source}).</source>
        <translation>Sprężyny pochodzą z biblioteki, a nie z tej maszyny (źródło: {source}).</translation>
    </message>
    <message>
        <source>The shaft is that of the table, which was changed since {source} was opened.</source>
        <translation>Wał jest wzięty z tabeli, którą zmieniono po otwarciu {source}.</translation>
    </message>
    <message>
        <source>{path}: stated is {stated}, but up to {to_hz} Hz the magnitude goes with the power {slope} of the frequency, as that of {found} does. State the unit as it is, or convert the file.</source>
        <translation>{path}: podano: {stated}, lecz do {to_hz} Hz moduł zmienia się z potęgą {slope} częstotliwości, jak {found}. Podaj właściwą jednostkę albo przelicz plik.</translation>
    </message>
    <message>
        <source>{path}: in {percent} % of its lines the receptance has a positive imaginary part. If force and motion are at one place, a direction, a unit or the sign of time is stated wrongly.</source>
        <translation>{path}: w {percent} % linii receptancja ma dodatnią część urojoną. Jeżeli siła i ruch są w jednym miejscu, błędnie podano kierunek, jednostkę albo znak czasu.</translation>
    </message>
    <message>
        <source>Shafts</source>
        <translation>Wały</translation>
    </message>
    <message>
        <source>spindle on springs</source>
        <translation>wrzeciono na sprężynach</translation>
    </message>
    <message>
        <source>spindle, measured</source>
        <translation>wrzeciono, zmierzone</translation>
    </message>
    <message>
        <source>clamped</source>
        <translation>utwierdzony</translation>
    </message>
    <message>
        <source>rest</source>
        <translation>podpora</translation>
    </message>
    <message>
        <source>z from the free end</source>
        <translation>z od wolnego końca</translation>
    </message>
    <message>
        <source>Mode shapes</source>
        <translation>Postacie drgań</translation>
    </message>
    <message>
        <source>Deflection, largest 1</source>
        <translation>Ugięcie, największe 1</translation>
    </message>
    <message>
        <source>{mode}: {frequency} Hz</source>
        <translation>{mode}: {frequency} Hz</translation>
    </message>
    <message>
        <source>Segments, from the free end</source>
        <translation>Odcinki, od wolnego końca</translation>
    </message>
    <message>
        <source>Mass {mass} kg, length {length_mm:1} mm</source>
        <translation>Masa {mass} kg, długość {length_mm:1} mm</translation>
    </message>
    <message>
        <source>Not held: no static compliance</source>
        <translation>Niepodparty: brak podatności statycznej</translation>
    </message>
    <message>
        <source>Static compliance {compliance} nm/N</source>
        <translation>Podatność statyczna {compliance} nm/N</translation>
    </message>
    <message>
        <source>Static compliance not known: the spindle is a table of receptances</source>
        <translation>Podatność statyczna nieznana: wrzeciono jest tabelą receptancji</translation>
    </message>
    <message>
        <source>Shaft in bending</source>
        <translation>Wał zginany</translation>
    </message>
    <message>
        <source>Spindles</source>
        <translation>Wrzeciona</translation>
    </message>
    <message>
        <source>Tap tests</source>
        <translation>Próby udarowe</translation>
    </message>
    <message>
        <source>L × 100 mm: deflection per moment</source>
        <translation>L × 100 mm: ugięcie na moment</translation>
    </message>
    <message>
        <source>P × (100 mm)²: rotation per moment</source>
        <translation>P × (100 mm)²: obrót na moment</translation>
    </message>
    <message>
        <source>Phase of the chuck face</source>
        <translation>Faza czoła uchwytu</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Reszta</translation>
    </message>
    <message>
        <source>Rod held out: measured and predicted</source>
        <translation>Pręt odłożony: zmierzony i przewidziany</translation>
    </message>
    <message>
        <source>Residual of each response</source>
        <translation>Reszta każdej charakterystyki</translation>
    </message>
    <message>
        <source>Measured by a hammer or shaker: UFF, CSV or MAT.</source>
        <translation>Zmierzona młotkiem lub wzbudnikiem: UFF, CSV albo MAT.</translation>
    </message>
    <message>
        <source>Whose computed response is drawn under the measured one: SHAFT.json or a stock file.</source>
        <translation>Którego obliczona charakterystyka jest rysowana pod zmierzoną: SHAFT.json albo plik półfabrykatu.</translation>
    </message>
    <message>
        <source>That holds the shaft: SPINDLE.json. Without it the shaft is free.</source>
        <translation>Które trzyma wał: SPINDLE.json. Bez niego wał jest swobodny.</translation>
    </message>
    <message>
        <source>Drop a measured frequency response here, or a shaft and its spindle.</source>
        <translation>Upuść tu zmierzoną charakterystykę częstotliwościową albo wał i jego wrzeciono.</translation>
    </message>
    <message>
        <source>FRF</source>
        <translation>FRF</translation>
    </message>
    <message>
        <source>Frequency response or shaft</source>
        <translation>Charakterystyka częstotliwościowa lub wał</translation>
    </message>
    <message>
        <source>a stiffness, not 0</source>
        <translation>sztywność różna od 0</translation>
    </message>
    <message>
        <source>Fitting modes</source>
        <translation>Dopasowywanie postaci</translation>
    </message>
    <message>
        <source>Computed response</source>
        <translation>Charakterystyka obliczona</translation>
    </message>
    <message>
        <source>Response</source>
        <translation>Charakterystyka</translation>
    </message>
    <message>
        <source>Fit modes</source>
        <translation>Dopasuj postacie</translation>
    </message>
    <message>
        <source>Finds the modes.</source>
        <translation>Znajduje postacie.</translation>
    </message>
    <message>
        <source>The response itself</source>
        <translation>Sama charakterystyka</translation>
    </message>
    <message>
        <source>The modal model</source>
        <translation>Model modalny</translation>
    </message>
    <message>
        <source>Use for lobes</source>
        <translation>Do krzywych workowych</translation>
    </message>
    <message>
        <source>Modes changed by hand</source>
        <translation>Postacie zmienione ręcznie</translation>
    </message>
    <message>
        <source>In place of those of the fit; drag a peak in the magnitude chart.</source>
        <translation>Zamiast dopasowanych; przeciągnij szczyt na wykresie modułu.</translation>
    </message>
    <message>
        <source>SHAFT.json or a stock file; fills the table of segments</source>
        <translation>SHAFT.json albo plik półfabrykatu; wypełnia tabelę odcinków</translation>
    </message>
    <message>
        <source>SPINDLE.json, or what the panel Spindle made; without it the shaft is free</source>
        <translation>SPINDLE.json albo wynik panelu Wrzeciono; bez niego wał jest swobodny</translation>
    </message>
    <message>
        <source>Drop a shaft here (SHAFT.json, stock text), or state its segments.</source>
        <translation>Upuść tu wał (SHAFT.json, tekst półfabrykatu) albo podaj jego odcinki.</translation>
    </message>
    <message>
        <source>Shaft or segments</source>
        <translation>Wał lub odcinki</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Sztywność</translation>
    </message>
    <message>
        <source>Against deflection.</source>
        <translation>Przeciw ugięciu.</translation>
    </message>
    <message>
        <source>The spring is multiplied by 1 + iη.</source>
        <translation>Sprężyna jest mnożona przez 1 + iη.</translation>
    </message>
    <message>
        <source>From the free end toward the chuck. A file fills the table; once it is changed, the table rules.</source>
        <translation>Od wolnego końca do uchwytu. Plik wypełnia tabelę; po zmianie obowiązuje tabela.</translation>
    </message>
    <message>
        <source>Segments changed from</source>
        <translation>Odcinki zmienione względem</translation>
    </message>
    <message>
        <source>The input that the table was changed from.</source>
        <translation>Dane, względem których zmieniono tabelę.</translation>
    </message>
    <message>
        <source>as the file states</source>
        <translation>jak podaje plik</translation>
    </message>
    <message>
        <source>Steel</source>
        <translation>Stal</translation>
    </message>
    <message>
        <source>Stainless steel</source>
        <translation>Stal nierdzewna</translation>
    </message>
    <message>
        <source>Aluminium</source>
        <translation>Aluminium</translation>
    </message>
    <message>
        <source>Brass</source>
        <translation>Mosiądz</translation>
    </message>
    <message>
        <source>Titanium</source>
        <translation>Tytan</translation>
    </message>
    <message>
        <source>Cast iron</source>
        <translation>Żeliwo</translation>
    </message>
    <message>
        <source>Handbook values of the library are marked as assumed.</source>
        <translation>Wartości z biblioteki są oznaczone jako przyjęte.</translation>
    </message>
    <message>
        <source>Own material</source>
        <translation>Własny materiał</translation>
    </message>
    <message>
        <source>Stated in place of the file and the library.</source>
        <translation>Podany zamiast pliku i biblioteki.</translation>
    </message>
    <message>
        <source>the spindle given, else free</source>
        <translation>podane wrzeciono, inaczej swobodny</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>sprężyny</translation>
    </message>
    <message>
        <source>clamped rigidly</source>
        <translation>sztywno utwierdzony</translation>
    </message>
    <message>
        <source>free</source>
        <translation>swobodny</translation>
    </message>
    <message>
        <source>Held at the chuck</source>
        <translation>Mocowanie w uchwycie</translation>
    </message>
    <message>
        <source>At the last segment&apos;s end.</source>
        <translation>Na końcu ostatniego odcinka.</translation>
    </message>
    <message>
        <source>Springs at the chuck</source>
        <translation>Sprężyny w uchwycie</translation>
    </message>
    <message>
        <source>Where it is held by springs.</source>
        <translation>Gdy trzymają go sprężyny.</translation>
    </message>
    <message>
        <source>MEASUREMENTS.json, with the file of frequency responses beside it</source>
        <translation>MEASUREMENTS.json, z plikiem charakterystyk częstotliwościowych obok</translation>
    </message>
    <message>
        <source>Drop tap tests on rods here (MEASUREMENTS.json), or choose springs or a known machine.</source>
        <translation>Upuść tu próby udarowe na prętach (MEASUREMENTS.json) albo wybierz sprężyny lub znaną maszynę.</translation>
    </message>
    <message>
        <source>Tap tests or springs</source>
        <translation>Próby udarowe lub sprężyny</translation>
    </message>
    <message>
        <source>Residual of the rod held out</source>
        <translation>Reszta pręta odłożonego</translation>
    </message>
    <message>
        <source>Of the responses used {used} % · responses: {responses} · lines: {lines}</source>
        <translation>Użytych charakterystyk {used} % · charakterystyk: {responses} · linii: {lines}</translation>
    </message>
    <message>
        <source>✓ accepted</source>
        <translation>✓ przyjęte</translation>
    </message>
    <message>
        <source>✗ not accepted</source>
        <translation>✗ nieprzyjęte</translation>
    </message>
    <message>
        <source>Static compliance of the chuck face</source>
        <translation>Podatność statyczna czoła uchwytu</translation>
    </message>
    <message>
        <source>Tilt {tilt} µrad/(N·m) · loss factor {loss}</source>
        <translation>Przechył {tilt} µrad/(N·m) · współczynnik strat {loss}</translation>
    </message>
    <message>
        <source>Quality of the identification</source>
        <translation>Jakość identyfikacji</translation>
    </message>
    <message>
        <source>tap tests</source>
        <translation>próby udarowe</translation>
    </message>
    <message>
        <source>lathe of the papers</source>
        <translation>tokarka z artykułów</translation>
    </message>
    <message>
        <source>stiff lathe (example)</source>
        <translation>sztywna tokarka (przykład)</translation>
    </message>
    <message>
        <source>soft lathe (example)</source>
        <translation>podatna tokarka (przykład)</translation>
    </message>
    <message>
        <source>Known from</source>
        <translation>Skąd znane</translation>
    </message>
    <message>
        <source>Machines of the library are assumed values to begin with.</source>
        <translation>Maszyny z biblioteki są wartościami przyjętymi na początek.</translation>
    </message>
    <message>
        <source>Where they are typed.</source>
        <translation>Gdy są wpisywane.</translation>
    </message>
    <message>
        <source>Largest residual</source>
        <translation>Największa reszta</translation>
    </message>
    <message>
        <source>Of the rod held out, else of all responses used.</source>
        <translation>Pręta odłożonego, inaczej wszystkich użytych charakterystyk.</translation>
    </message>
    <message>
        <source>Face {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1} mm</source>
        <translation>Czoło {value_mm:+3} ± {uncertainty_mm:3} mm · z {from_mm:1} mm</translation>
    </message>
    <message>
        <source>Natural frequencies of beams</source>
        <translation>Częstotliwości własne belek</translation>
    </message>
    <message>
        <source>Receptances of beams</source>
        <translation>Receptancje belek</translation>
    </message>
    <message>
        <source>Two halves of a shaft coupled</source>
        <translation>Dwie sprzężone połowy wałka</translation>
    </message>
    <message>
        <source>Rod of the source papers on its springs</source>
        <translation>Pręt z artykułów źródłowych na sprężynach</translation>
    </message>
    <message>
        <source>Spindle found from made responses</source>
        <translation>Wrzeciono wyznaczone z wytworzonych charakterystyk</translation>
    </message>
    <message>
        <source>the exact relation: the published one has no process damping</source>
        <translation>zależność dokładna: opublikowana nie ma tłumienia procesowego</translation>
    </message>
    <message>
        <source>the cutting coefficient for the process damping</source>
        <translation>współczynnik skrawania dla tłumienia procesowego</translation>
    </message>
    <message>
        <source>the diameter for the process damping</source>
        <translation>średnica dla tłumienia procesowego</translation>
    </message>
    <message>
        <source>Process damping C</source>
        <translation>Tłumienie procesowe C</translation>
    </message>
    <message>
        <source>Of the force C (a/v) ẋ, v the cutting speed; needs coefficient, diameter and the exact relation.</source>
        <translation>Z siły C (a/v) ẋ, v to prędkość skrawania; wymaga współczynnika, średnicy i zależności dokładnej.</translation>
    </message>
    <message>
        <source>Of the turned surface; for the process damping.</source>
        <translation>Powierzchni toczonej; dla tłumienia procesowego.</translation>
    </message>
    <message>
        <source>the cutting coefficient</source>
        <translation>współczynnik skrawania</translation>
    </message>
    <message>
        <source>Operating speed</source>
        <translation>Prędkość robocza</translation>
    </message>
    <message>
        <source>Of a point that is asked about: is it stable, and how surely?</source>
        <translation>Punktu, o który się pyta: czy jest stabilny i jak pewnie?</translation>
    </message>
    <message>
        <source>Operating depth of cut</source>
        <translation>Robocza głębokość skrawania</translation>
    </message>
    <message>
        <source>Of that point, in mm; without a cutting coefficient in multiples of the least limit.</source>
        <translation>Tego punktu, w mm; bez współczynnika skrawania w wielokrotnościach najmniejszej granicy.</translation>
    </message>
    <message>
        <source>speed and depth of the operating point</source>
        <translation>prędkość i głębokość punktu pracy</translation>
    </message>
    <message>
        <source>Operating point</source>
        <translation>Punkt pracy</translation>
    </message>
    <message>
        <source>Limit at this speed</source>
        <translation>Granica przy tej prędkości</translation>
    </message>
    <message>
        <source>Stable</source>
        <translation>Stabilny</translation>
    </message>
    <message>
        <source>Probability that it is stable</source>
        <translation>Prawdopodobieństwo, że jest stabilny</translation>
    </message>
    <message>
        <source>the diameter that is left</source>
        <translation>pozostająca średnica</translation>
    </message>
    <message>
        <source>more than the bore</source>
        <translation>większa niż otwór</translation>
    </message>
    <message>
        <source>the stretch that the tool cuts, such as 0:100</source>
        <translation>odcinek skrawany przez narzędzie, na przykład 0:100</translation>
    </message>
    <message>
        <source>a range such as 0:100</source>
        <translation>zakres, na przykład 0:100</translation>
    </message>
    <message>
        <source>the depth of cut of the pass</source>
        <translation>głębokość skrawania przejścia</translation>
    </message>
    <message>
        <source>the cutting coefficient for a pass</source>
        <translation>współczynnik skrawania dla przejścia</translation>
    </message>
    <message>
        <source>Pass</source>
        <translation>Przejście</translation>
    </message>
    <message>
        <source>Stretch that the tool cuts, 0:100 from the free end toward the chuck: lobes for each place.</source>
        <translation>Odcinek skrawany przez narzędzie, 0:100 od wolnego końca w stronę uchwytu: krzywe workowe dla każdego miejsca.</translation>
    </message>
    <message>
        <source>Depth of the pass</source>
        <translation>Głębokość przejścia</translation>
    </message>
    <message>
        <source>On the radius; the shaft is thinner by it behind the tool.</source>
        <translation>Na promieniu; o tyle wałek jest cieńszy za narzędziem.</translation>
    </message>
    <message>
        <source>Stations of the pass</source>
        <translation>Stacje przejścia</translation>
    </message>
    <message>
        <source>Places of the tool, evenly over the pass.</source>
        <translation>Położenia narzędzia, równomiernie wzdłuż przejścia.</translation>
    </message>
    <message>
        <source>Place of the tool z</source>
        <translation>Położenie narzędzia z</translation>
    </message>
    <message>
        <source>Least limit over the pass</source>
        <translation>Najmniejsza granica wzdłuż przejścia</translation>
    </message>
    <message>
        <source>least limit</source>
        <translation>najmniejsza granica</translation>
    </message>
    <message>
        <source>depth of the pass</source>
        <translation>głębokość przejścia</translation>
    </message>
    <message>
        <source>The shaft is thinner by the depth of cut behind the tool. Of all speeds shown {speed} 1/min bears the most over the whole pass: {depth} mm.</source>
        <translation>Za narzędziem wałek jest cieńszy o głębokość skrawania. Ze wszystkich pokazanych prędkości {speed} obr/min znosi najwięcej w całym przejściu: {depth} mm.</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
    <message>
        <source>diameter left (mm)</source>
        <translation>pozostająca średnica (mm)</translation>
    </message>
    <message>
        <source>least limit (mm)</source>
        <translation>najmniejsza granica (mm)</translation>
    </message>
    <message>
        <source>Lobes over the pass</source>
        <translation>Krzywe workowe wzdłuż przejścia</translation>
    </message>
    <message>
        <source>the speed of the spindle</source>
        <translation>prędkość wrzeciona</translation>
    </message>
    <message>
        <source>the depth of cut</source>
        <translation>głębokość skrawania</translation>
    </message>
    <message>
        <source>Of the cut that is simulated.</source>
        <translation>Symulowanego skrawania.</translation>
    </message>
    <message>
        <source>Force along the chip thickness over its area.</source>
        <translation>Siła wzdłuż grubości wióra podzielona przez jego pole.</translation>
    </message>
    <message>
        <source>Chip thickness without vibration; says when the tool leaves the cut.</source>
        <translation>Grubość wióra bez drgań; mówi, kiedy narzędzie wychodzi z materiału.</translation>
    </message>
    <message>
        <source>That are simulated.</source>
        <translation>Które są symulowane.</translation>
    </message>
    <message>
        <source>Of the force C (a/v) ẋ, v the cutting speed; needs the diameter.</source>
        <translation>Z siły C (a/v) ẋ, v to prędkość skrawania; wymaga średnicy.</translation>
    </message>
    <message>
        <source>at least one mode</source>
        <translation>co najmniej jedna postać</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>nierozstrzygnięte</translation>
    </message>
    <message>
        <source>Growth per revolution</source>
        <translation>Wzrost na obrót</translation>
    </message>
    <message>
        <source>Its change by half the time step</source>
        <translation>Jego zmiana przy połowie kroku czasu</translation>
    </message>
    <message>
        <source>Frequency of the vibration</source>
        <translation>Częstotliwość drgań</translation>
    </message>
    <message>
        <source>Amplitude at the end</source>
        <translation>Amplituda na końcu</translation>
    </message>
    <message>
        <source>Time out of the cut at the end</source>
        <translation>Czas poza materiałem na końcu</translation>
    </message>
    <message>
        <source>Deflection of the steady cut</source>
        <translation>Ugięcie przy skrawaniu bez drgań</translation>
    </message>
    <message>
        <source>Waves in a revolution</source>
        <translation>Fale na obrót</translation>
    </message>
    <message>
        <source>Simulated time</source>
        <translation>Symulowany czas</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Krok czasu</translation>
    </message>
    <message>
        <source>Time steps in a revolution</source>
        <translation>Kroki czasu na obrót</translation>
    </message>
    <message>
        <source>Full scale of the sound</source>
        <translation>Pełna skala dźwięku</translation>
    </message>
    <message>
        <source>Deflection of the tool</source>
        <translation>Ugięcie narzędzia</translation>
    </message>
    <message>
        <source>Deflection</source>
        <translation>Ugięcie</translation>
    </message>
    <message>
        <source>steady cut</source>
        <translation>skrawanie bez drgań</translation>
    </message>
    <message>
        <source>Height above the bottom of the steady cut</source>
        <translation>Wysokość nad dnem skrawania bez drgań</translation>
    </message>
    <message>
        <source>outer wave, left before</source>
        <translation>fala zewnętrzna, pozostawiona wcześniej</translation>
    </message>
    <message>
        <source>inner wave, path of the tool</source>
        <translation>fala wewnętrzna, tor narzędzia</translation>
    </message>
    <message>
        <source>Growth of the vibration per revolution</source>
        <translation>Wzrost drgań na obrót</translation>
    </message>
    <message>
        <source>{frequency} Hz · amplitude {amplitude} mm · out of the cut {lost} %</source>
        <translation>{frequency} Hz · amplituda {amplitude} mm · poza materiałem {lost} %</translation>
    </message>
    <message>
        <source>Simulated cut</source>
        <translation>Symulowane skrawanie</translation>
    </message>
    <message>
        <source>Simulation of a cut</source>
        <translation>Symulacja skrawania</translation>
    </message>
    <message>
        <source>Waveform</source>
        <translation>Przebieg</translation>
    </message>
    <message>
        <source>The modes go on exactly from step to step under a force that runs straight between them; the chip is as thick as the feed and the waves of earlier revolutions leave it, and has no force where the tool is out of the cut. The growth is that of the cut without loss of contact.</source>
        <translation>Postacie drgań są całkowane dokładnie od kroku do kroku przy sile zmiennej między nimi liniowo; wiór jest tak gruby, jak pozostawiają go posuw i fale wcześniejszych obrotów, i nie ma siły, gdy narzędzie jest poza materiałem. Wzrost dotyczy skrawania bez utraty kontaktu.</translation>
    </message>
    <message>
        <source>at least two columns and rows</source>
        <translation>co najmniej dwie kolumny i dwa wiersze</translation>
    </message>
    <message>
        <source>a range such as 1000:4000</source>
        <translation>zakres, na przykład 1000:4000</translation>
    </message>
    <message>
        <source>a range such as 0:1</source>
        <translation>zakres, na przykład 0:1</translation>
    </message>
    <message>
        <source>Natural logarithm of the growth</source>
        <translation>Logarytm naturalny wzrostu</translation>
    </message>
    <message>
        <source>The simulation would take {steps} time steps; at most {most} are allowed. Ask for fewer revolutions.</source>
        <translation>Symulacja wymagałaby {steps} kroków czasu; dozwolone jest najwyżej {most}. Podaj mniej obrotów.</translation>
    </message>
    <message>
        <source>Nothing chatters at the speeds shown.</source>
        <translation>Przy pokazanych prędkościach nic nie drga.</translation>
    </message>
    <message>
        <source>Limits of the worked example</source>
        <translation>Granice z przykładu obliczeniowego</translation>
    </message>
    <message>
        <source>Characteristic equation at the lobes</source>
        <translation>Równanie charakterystyczne na krzywych workowych</translation>
    </message>
    <message>
        <source>Characteristic equation with process damping</source>
        <translation>Równanie charakterystyczne z tłumieniem procesowym</translation>
    </message>
    <message>
        <source>Speeds of the source papers</source>
        <translation>Prędkości z artykułów źródłowych</translation>
    </message>
    <message>
        <source>Growth of simulated cuts</source>
        <translation>Wzrost w symulowanych skrawaniach</translation>
    </message>
    <message>
        <source>the shaft of a pass</source>
        <translation>wałek przejścia</translation>
    </message>
    <message>
        <source>Simulating</source>
        <translation>Symulacja</translation>
    </message>
    <message>
        <source>Drop the file of a spindle here, then type diameter, overhang and cutting speed.</source>
        <translation>Upuść tu plik wrzeciona, potem podaj średnicę, wysięg i prędkość skrawania.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Prędkość</translation>
    </message>
    <message>
        <source>Overhang L</source>
        <translation>Wysięg L</translation>
    </message>
    <message>
        <source>Least cutting speed</source>
        <translation>Najmniejsza prędkość skrawania</translation>
    </message>
    <message>
        <source>That the tool allows.</source>
        <translation>Dopuszczana przez narzędzie.</translation>
    </message>
    <message>
        <source>Greatest cutting speed</source>
        <translation>Największa prędkość skrawania</translation>
    </message>
    <message>
        <source>Material of the bar</source>
        <translation>Materiał pręta</translation>
    </message>
    <message>
        <source>Without it steel is assumed.</source>
        <translation>Bez niego przyjmuje się stal.</translation>
    </message>
    <message>
        <source>{speed} 1/min · least limit at z {z} mm, chatter at {frequency} Hz</source>
        <translation>{speed} obr/min · najmniejsza granica przy z {z} mm, drgania o częstotliwości {frequency} Hz</translation>
    </message>
    <message>
        <source>Stability over a pass</source>
        <translation>Stabilność na przejściu</translation>
    </message>
    <message>
        <source>At each station the shaft as it is then, on its spindle, gives the limit of regenerative chatter at the tool.</source>
        <translation>Na każdej stacji wał w swoim ówczesnym kształcie, na wrzecionie, daje granicę drgań regeneracyjnych przy narzędziu.</translation>
    </message>
    <message>
        <source>Drop a shaft and a spindle here, then state the pass, its depth and the coefficient.</source>
        <translation>Upuść tu wał i wrzeciono, potem podaj przejście, jego głębokość i współczynnik.</translation>
    </message>
    <message>
        <source>Depth of cut beyond the limit</source>
        <translation>Głębokość skrawania ponad granicę</translation>
    </message>
    <message>
        <source>Beyond the limit</source>
        <translation>Ponad granicę</translation>
    </message>
    <message>
        <source>Outer and inner wave</source>
        <translation>Fala zewnętrzna i wewnętrzna</translation>
    </message>
    <message>
        <source>{whole} whole waves, ε = {phase}°</source>
        <translation>{whole} całych fal, ε = {phase}°</translation>
    </message>
    <message>
        <source>chip</source>
        <translation>wiór</translation>
    </message>
    <message>
        <source>Turned surface, unrolled</source>
        <translation>Toczona powierzchnia, rozwinięta</translation>
    </message>
    <message>
        <source>Along the axis</source>
        <translation>Wzdłuż osi</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Wysokość</translation>
    </message>
    <message>
        <source>Amplitude from revolution to revolution</source>
        <translation>Amplituda z obrotu na obrót</translation>
    </message>
    <message>
        <source>Revolution</source>
        <translation>Obrót</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>symulacja</translation>
    </message>
    <message>
        <source>by the growth alone</source>
        <translation>z samego wzrostu</translation>
    </message>
    <message>
        <source>Spectrum of the deflection</source>
        <translation>Widmo ugięcia</translation>
    </message>
    <message>
        <source>red: the vibration grows, blue: it dies out</source>
        <translation>czerwony: drganie rośnie, niebieski: gaśnie</translation>
    </message>
    <message>
        <source>Published relation against the exact one</source>
        <translation>Zależność opublikowana a dokładna</translation>
    </message>
    <message>
        <source>exact limit</source>
        <translation>granica dokładna</translation>
    </message>
    <message>
        <source>limit as published, N = 60 f/k</source>
        <translation>granica opublikowana, N = 60 f/k</translation>
    </message>
    <message>
        <source>One revolution later the tool meets the wave that it left.</source>
        <translation>Po jednym obrocie narzędzie spotyka falę, którą zostawiło.</translation>
    </message>
    <message>
        <source>The chip is as thick as the feed and both waves make it; the force follows it.</source>
        <translation>Grubość wióra wynika z posuwu i obu fal, a siła idzie za nią.</translation>
    </message>
    <message>
        <source>Between two revolutions lie whole waves and a rest, the phase ε.</source>
        <translation>Między dwoma obrotami mieszczą się całe fale i reszta, faza ε.</translation>
    </message>
    <message>
        <source>The wave comes back larger after every revolution: it grows to chatter.</source>
        <translation>Fala wraca po każdym obrocie większa: rośnie i przechodzi w drgania samowzbudne.</translation>
    </message>
    <message>
        <source>The wave comes back smaller after every revolution: it dies out.</source>
        <translation>Fala wraca po każdym obrocie mniejsza: gaśnie.</translation>
    </message>
    <message>
        <source>At this speed the limit follows from the real part of the receptance there.</source>
        <translation>Przy tej prędkości granica wynika z części rzeczywistej receptancji.</translation>
    </message>
    <message>
        <source>A lobe ties speed and frequency by whole waves and phase.</source>
        <translation>Krzywa workowa wiąże prędkość z częstotliwością przez całe fale i fazę.</translation>
    </message>
    <message>
        <source>The published relation leaves the phase out and moves every lobe.</source>
        <translation>Opublikowana zależność pomija fazę i przesuwa każdą krzywą.</translation>
    </message>
    <message>
        <source>Decay after a blow</source>
        <translation>Zanikanie po uderzeniu</translation>
    </message>
    <message>
        <source>Lowest speed</source>
        <translation>Najniższa prędkość</translation>
    </message>
    <message>
        <source>Highest speed</source>
        <translation>Najwyższa prędkość</translation>
    </message>
    <message>
        <source>Cuts that may be listened to</source>
        <translation>Skrawania, których można posłuchać</translation>
    </message>
    <message>
        <source>Whole waves k</source>
        <translation>Całe fale k</translation>
    </message>
    <message>
        <source>Frequency of the chatter</source>
        <translation>Częstotliwość drgań samowzbudnych</translation>
    </message>
    <message>
        <source>Frequency of the chatter at the least limit</source>
        <translation>Częstotliwość drgań przy najmniejszej granicy</translation>
    </message>
    <message>
        <source>Limit at every speed</source>
        <translation>Granica przy każdej prędkości</translation>
    </message>
    <message>
        <source>The cut is</source>
        <translation>Skrawanie jest</translation>
    </message>
    <message>
        <source>A safe speed</source>
        <translation>Bezpieczna prędkość</translation>
    </message>
    <message>
        <source>Counting waves</source>
        <translation>Liczenie fal</translation>
    </message>
    <message>
        <source>Damping from a decay</source>
        <translation>Tłumienie z zanikania</translation>
    </message>
    <message>
        <source>Stable or chatter?</source>
        <translation>Stabilnie czy z drganiami?</translation>
    </message>
    <message>
        <source>The cut is to be {depth_mm:2} mm deep. Find a spindle speed between {from_rpm:0} and {to_rpm:0} 1/min at which it does not chatter. You may listen to {cuts:0} cuts first.</source>
        <translation>Głębokość skrawania ma wynosić {depth_mm:2} mm. Znajdź prędkość wrzeciona między {from_rpm:0} a {to_rpm:0} obr/min, przy której nie ma drgań. Najpierw możesz posłuchać skrawań: {cuts:0}.</translation>
    </message>
    <message>
        <source>This cut at {speed_rpm:0} 1/min chatters. Count the waves on the surface over one revolution: how many whole waves are there?</source>
        <translation>To skrawanie przy {speed_rpm:0} obr/min drga. Policz fale na powierzchni jednego obrotu: ile jest całych fal?</translation>
    </message>
    <message>
        <source>The tool was hit once with a hammer and rings out. Read two amplitudes some periods apart: how large is the damping ratio in per cent?</source>
        <translation>Narzędzie uderzono raz młotkiem i wybrzmiewa. Odczytaj dwie amplitudy odległe o kilka okresów: ile procent wynosi stopień tłumienia?</translation>
    </message>
    <message>
        <source>Listen to this cut at {speed_rpm:0} 1/min and look at its waveform: how many times a second does the tool swing?</source>
        <translation>Posłuchaj tego skrawania przy {speed_rpm:0} obr/min i obejrzyj jego przebieg: ile razy na sekundę wychyla się narzędzie?</translation>
    </message>
    <message>
        <source>Every cut of less than {least_mm:2} mm is stable; at the least limit the chatter has {bottom_hz:1} Hz. Predict: is a cut of {depth_mm:2} mm at {speed_rpm:0} 1/min stable, or does it chatter? The exact relation and the shortcut of the papers disagree here.</source>
        <translation>Każde skrawanie płytsze niż {least_mm:2} mm jest stabilne; przy najmniejszej granicy drgania mają {bottom_hz:1} Hz. Przewidź: czy skrawanie {depth_mm:2} mm przy {speed_rpm:0} obr/min jest stabilne, czy drga? Zależność dokładna i skrót z publikacji dają tu różne odpowiedzi.</translation>
    </message>
    <message>
        <source>At {speed_rpm:0} 1/min the limit is {limit_mm:2} mm, {depth_mm:2} mm were to be cut. The best speed is {best_rpm:0} 1/min with at least {best_mm:2} mm even if the speed is 1 % off: there 60 f/N with the natural frequency f = {natural_hz:0} Hz is {best_waves:2}, close to a whole number, and the wave is met almost in step.</source>
        <translation>Przy {speed_rpm:0} obr/min granica wynosi {limit_mm:2} mm, a miało być {depth_mm:2} mm. Najlepsza prędkość to {best_rpm:0} obr/min z granicą co najmniej {best_mm:2} mm, nawet gdy prędkość odbiega o 1 %: 60 f/N z częstotliwością własną f = {natural_hz:0} Hz wynosi tam {best_waves:2}, blisko liczby całkowitej, i fala spotykana jest niemal zgodnie.</translation>
    </message>
    <message>
        <source>60 f/N = 60 · {frequency_hz:1} Hz / {speed_rpm:0} 1/min = {waves:2} waves: {k:0} whole waves and a phase ε of {phase_deg:0}°.</source>
        <translation>60 f/N = 60 · {frequency_hz:1} Hz / {speed_rpm:0} obr/min = {waves:2} fali: {k:0} całych fal i faza ε równa {phase_deg:0}°.</translation>
    </message>
    <message>
        <source>Over {periods:0} periods the amplitude falls from {first_mm:4} mm to {last_mm:4} mm: δ = ln({first_mm:4}/{last_mm:4})/{periods:0} = {decrement:3}, and ζ = δ/√(4π² + δ²) = {damping_percent:2} %.</source>
        <translation>Przez {periods:0} okresów amplituda spada z {first_mm:4} mm do {last_mm:4} mm: δ = ln({first_mm:4}/{last_mm:4})/{periods:0} = {decrement:3}, a ζ = δ/√(4π² + δ²) = {damping_percent:2} %.</translation>
    </message>
    <message>
        <source>Ten swings last {ten_ms:1} ms: f = {frequency_hz:1} Hz. The natural frequency is {natural_hz:1} Hz; chatter lies a little above it.</source>
        <translation>Dziesięć wychyleń trwa {ten_ms:1} ms: f = {frequency_hz:1} Hz. Częstotliwość własna to {natural_hz:1} Hz; drgania samowzbudne leżą nieco wyżej.</translation>
    </message>
    <message>
        <source>60 f/N = {waves:2} waves. The exact limit at this speed is {limit_mm:2} mm, that of the shortcut N = 60 f/k {published_mm:2} mm, the depth {depth_mm:2} mm. The simulation decides: from revolution to revolution the vibration changes by the factor {growth:3}.</source>
        <translation>60 f/N = {waves:2} fali. Dokładna granica przy tej prędkości wynosi {limit_mm:2} mm, ze skrótu N = 60 f/k {published_mm:2} mm, a głębokość {depth_mm:2} mm. Rozstrzyga symulacja: z obrotu na obrót drganie zmienia się {growth:3} razy.</translation>
    </message>
    <message>
        <source>Hidden machine</source>
        <translation>Ukryta maszyna</translation>
    </message>
    <message>
        <source>A machine of an exercise: one mode, which is to be found out.</source>
        <translation>Maszyna z ćwiczenia: jedna postać drgań, którą trzeba odgadnąć.</translation>
    </message>
    <message>
        <source>Speed answered</source>
        <translation>Podana prędkość</translation>
    </message>
    <message>
        <source>Best speed</source>
        <translation>Najlepsza prędkość</translation>
    </message>
    <message>
        <source>Least limit within 1 % of it</source>
        <translation>Najmniejsza granica w zakresie 1 % od niej</translation>
    </message>
    <message>
        <source>60 f/N there</source>
        <translation>60 f/N przy niej</translation>
    </message>
    <message>
        <source>Phase ε between the waves</source>
        <translation>Faza ε między falami</translation>
    </message>
    <message>
        <source>Periods</source>
        <translation>Okresy</translation>
    </message>
    <message>
        <source>Amplitude before</source>
        <translation>Amplituda na początku</translation>
    </message>
    <message>
        <source>Amplitude after</source>
        <translation>Amplituda na końcu</translation>
    </message>
    <message>
        <source>Logarithmic decrement δ</source>
        <translation>Logarytmiczny dekrement tłumienia δ</translation>
    </message>
    <message>
        <source>Ten swings</source>
        <translation>Dziesięć wychyleń</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Limit at this speed as published</source>
        <translation>Granica przy tej prędkości według publikacji</translation>
    </message>
    <message>
        <source>a title: “# Title”</source>
        <translation>tytuł: „# Tytuł”</translation>
    </message>
    <message>
        <source>a step: “## Heading”</source>
        <translation>krok: „## Nagłówek”</translation>
    </message>
    <message>
        <source>the end of the block: “```”</source>
        <translation>koniec bloku: „```”</translation>
    </message>
    <message>
        <source>a heading</source>
        <translation>nagłówek</translation>
    </message>
    <message>
        <source>one title only; a step begins with “## ”</source>
        <translation>tylko jeden tytuł; krok zaczyna się od „## ”</translation>
    </message>
    <message>
        <source>fewer steps</source>
        <translation>mniej kroków</translation>
    </message>
    <message>
        <source>only one of its kind in a step</source>
        <translation>tylko jeden taki w kroku</translation>
    </message>
    <message>
        <source>each only once</source>
        <translation>każdy tylko raz</translation>
    </message>
    <message>
        <source>“key = value”</source>
        <translation>„klucz = wartość”</translation>
    </message>
    <message>
        <source>an exercise with the seed</source>
        <translation>ćwiczenie z numerem</translation>
    </message>
    <message>
        <source>fewer checks</source>
        <translation>mniej warunków</translation>
    </message>
    <message>
        <source>a number with a decimal point, or a quantity that is one</source>
        <translation>liczba z kropką dziesiętną albo wielkość liczbowa</translation>
    </message>
    <message>
        <source>a task beside the check: “task: …”</source>
        <translation>zadanie obok warunku: „task: …”</translation>
    </message>
    <message>
        <source>a lesson in Markdown</source>
        <translation>lekcja w formacie Markdown</translation>
    </message>
    <message>
        <source>a lesson of at most 1 MiB</source>
        <translation>lekcja o wielkości najwyżej 1 MiB</translation>
    </message>
    <message>
        <source>Growth</source>
        <translation>Wzrost</translation>
    </message>
    <message>
        <source>Inner and outer wave</source>
        <translation>Fala wewnętrzna i zewnętrzna</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Widmo</translation>
    </message>
    <message>
        <source>Paper against exact</source>
        <translation>Publikacja a dokładna</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Dlaczego?</translation>
    </message>
    <message>
        <source>As published</source>
        <translation>Jak w publikacji</translation>
    </message>
    <message>
        <source>Scenario</source>
        <translation>Scenariusz</translation>
    </message>
    <message>
        <source>Lobe k</source>
        <translation>Krzywa k</translation>
    </message>
    <message>
        <source>Natural frequency next to it</source>
        <translation>Najbliższa częstotliwość własna</translation>
    </message>
    <message>
        <source>Least limit within 2 % of the speed</source>
        <translation>Najmniejsza granica w zakresie 2 % prędkości</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>Heard</source>
        <translation>Słuchano</translation>
    </message>
    <message>
        <source>Points of the exercise</source>
        <translation>Punkty za ćwiczenie</translation>
    </message>
    <message>
        <source>Short stiff part</source>
        <translation>Krótka sztywna część</translation>
    </message>
    <message>
        <source>A short part in a good chuck: it bends little, and takes a deep cut before it chatters.</source>
        <translation>Krótka część w dobrym uchwycie: mało się ugina i znosi głębokie skrawanie, zanim zacznie drgać.</translation>
    </message>
    <message>
        <source>Slender part</source>
        <translation>Smukła część</translation>
    </message>
    <message>
        <source>A long thin part held at one end: one weak mode at 223 Hz, the example of the published papers.</source>
        <translation>Długa cienka część zamocowana z jednej strony: jedna słaba postać 223 Hz, przykład z publikacji.</translation>
    </message>
    <message>
        <source>Slender part with tailstock</source>
        <translation>Smukła część z konikiem</translation>
    </message>
    <message>
        <source>The same part with a centre in its end: two modes, each much stiffer than the one before.</source>
        <translation>Ta sama część podparta kłem: dwie postacie, każda o wiele sztywniejsza niż poprzednio.</translation>
    </message>
    <message>
        <source>Worn spindle bearing</source>
        <translation>Zużyte łożysko wrzeciona</translation>
    </message>
    <message>
        <source>The short part again, in a spindle whose worn bearing is loose and damps little: the spindle chatters now.</source>
        <translation>Znów krótka część, lecz zużyte łożysko wrzeciona ma luz i słabo tłumi: teraz drga wrzeciono.</translation>
    </message>
    <message>
        <source>Pupil</source>
        <translation>Uczeń</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Ćwiczenie</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numer</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Odpowiedź</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Poprawna</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Odpowiedzi</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>Poprawne</translation>
    </message>
    <message>
        <source>Most points</source>
        <translation>Punktów najwyżej</translation>
    </message>
    <message>
        <source>Training: results</source>
        <translation>Szkolenie: wyniki</translation>
    </message>
    <message>
        <source>All answers</source>
        <translation>Wszystkie odpowiedzi</translation>
    </message>
    <message>
        <source>By pupil</source>
        <translation>Według uczniów</translation>
    </message>
    <message>
        <source>By exercise</source>
        <translation>Według ćwiczeń</translation>
    </message>
    <message>
        <source>Every exercise follows from its kind and number alone: the same number gives the same exercise, which was graded again for this sheet.</source>
        <translation>Każde ćwiczenie wynika z samego rodzaju i numeru: ten sam numer daje to samo ćwiczenie, a do tego arkusza oceniono je ponownie.</translation>
    </message>
    <message>
        <source>Of a machine of your own, in place of the scenario: UFF, CSV or MAT.</source>
        <translation>Własnej maszyny, zamiast scenariusza: UFF, CSV lub MAT.</translation>
    </message>
    <message>
        <source>Choose a scenario, or drop a frequency response of your own here.</source>
        <translation>Wybierz scenariusz albo upuść tu własną charakterystykę częstotliwościową.</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Szkolenie</translation>
    </message>
    <message>
        <source>Does it chatter?</source>
        <translation>Czy są drgania?</translation>
    </message>
    <message>
        <source>listen</source>
        <translation>posłuchaj</translation>
    </message>
    <message>
        <source>{speed} 1/min · depth {depth_mm:3} mm</source>
        <translation>{speed} obr/min · głębokość {depth_mm:3} mm</translation>
    </message>
    <message>
        <source>Training: a cut and its chatter</source>
        <translation>Szkolenie: skrawanie i jego drgania</translation>
    </message>
    <message>
        <source>The cut</source>
        <translation>Skrawanie</translation>
    </message>
    <message>
        <source>Part and machine</source>
        <translation>Część i maszyna</translation>
    </message>
    <message>
        <source>A machine with known modes; a response or modes of your own take its place.</source>
        <translation>Maszyna o znanych postaciach drgań; własna charakterystyka lub postacie ją zastępują.</translation>
    </message>
    <message>
        <source>Teacher mode: hide the chart</source>
        <translation>Tryb nauczyciela: ukryj wykres</translation>
    </message>
    <message>
        <source>The class hears the cut and sees its wave, but neither limit nor verdict.</source>
        <translation>Klasa słyszy skrawanie i widzi falę, ale nie granicę ani ocenę.</translation>
    </message>
    <message>
        <source>Chip thickness without vibration.</source>
        <translation>Grubość wióra bez drgań.</translation>
    </message>
    <message>
        <source>Range that is shown, 1000:4000.</source>
        <translation>Pokazany zakres, 1000:4000.</translation>
    </message>
    <message>
        <source>Of a machine of your own, where there is no measured frequency response.</source>
        <translation>Własnej maszyny, gdy nie ma zmierzonej charakterystyki.</translation>
    </message>
    <message>
        <source>own machine</source>
        <translation>własna maszyna</translation>
    </message>
    <message>
        <source>The machine and part of the shop.</source>
        <translation>Maszyna i część z warsztatu.</translation>
    </message>
    <message>
        <source>the cut vibrates at {frequency} Hz</source>
        <translation>skrawanie drga z {frequency} Hz</translation>
    </message>
    <message>
        <source>Its rest slants the marks on the surface and repeats them along the axis.</source>
        <translation>Jej reszta pochyla ślady na powierzchni i powtarza je wzdłuż osi.</translation>
    </message>
    <message>
        <source>A feed of {feed_mm_rev} mm per revolution leaves uncut rings: it has to be below twice the corner radius of {corner_radius_mm} mm.</source>
        <translation>Posuw {feed_mm_rev} mm na obrót zostawia nieskrawane pierścienie: musi być mniejszy niż dwa promienie naroża {corner_radius_mm} mm.</translation>
    </message>
    <message>
        <source>A cut has no feed per revolution; found {feed_mm_rev} mm per revolution.</source>
        <translation>Skrawanie nie ma posuwu na obrót; znaleziono {feed_mm_rev} mm na obrót.</translation>
    </message>
    <message>
        <source>The cutting edge stands at {entering_angle_deg}° to the direction of the feed; expected from {minimum_deg}° to {maximum_deg}°.</source>
        <translation>Krawędź skrawająca stoi pod kątem {entering_angle_deg}° do kierunku posuwu; oczekiwano od {minimum_deg}° do {maximum_deg}°.</translation>
    </message>
    <message>
        <source>K_tc</source>
        <translation>K_tc</translation>
    </message>
    <message>
        <source>Cutting coefficient along the cutting speed, by chip area.</source>
        <translation>Współczynnik skrawania wzdłuż prędkości skrawania, od pola przekroju warstwy.</translation>
    </message>
    <message>
        <source>K_te</source>
        <translation>K_te</translation>
    </message>
    <message>
        <source>Edge coefficient along the cutting speed, by contact length.</source>
        <translation>Współczynnik krawędziowy wzdłuż prędkości skrawania, od długości styku.</translation>
    </message>
    <message>
        <source>K_rfc</source>
        <translation>K_rfc</translation>
    </message>
    <message>
        <source>Cutting coefficient along the flow of the chip, by chip area.</source>
        <translation>Współczynnik skrawania wzdłuż spływu wióra, od pola przekroju warstwy.</translation>
    </message>
    <message>
        <source>K_rfe</source>
        <translation>K_rfe</translation>
    </message>
    <message>
        <source>Edge coefficient along the flow of the chip, by contact length.</source>
        <translation>Współczynnik krawędziowy wzdłuż spływu wióra, od długości styku.</translation>
    </message>
    <message>
        <source>Lead angle</source>
        <translation>Kąt odchylenia krawędzi</translation>
    </message>
    <message>
        <source>The edge enters at 90° less this: -5° is an entering angle of 95°.</source>
        <translation>Krawędź wchodzi pod kątem 90° minus ten kąt: -5° to kąt przystawienia 95°.</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>Promień naroża</translation>
    </message>
    <message>
        <source>arc of the corner and straight edge</source>
        <translation>łuk naroża i prosta krawędź</translation>
    </message>
    <message>
        <source>chord between the ends of the edge in cut</source>
        <translation>cięciwa między końcami czynnej krawędzi</translation>
    </message>
    <message>
        <source>straight edge without a corner</source>
        <translation>prosta krawędź bez naroża</translation>
    </message>
    <message>
        <source>every pass</source>
        <translation>każde przejście</translation>
    </message>
    <message>
        <source>passes that leave the final contour</source>
        <translation>przejścia, które zostawiają kontur końcowy</translation>
    </message>
    <message>
        <source>Corrected passes</source>
        <translation>Korygowane przejścia</translation>
    </message>
    <message>
        <source>Which passes are written anew.</source>
        <translation>Które przejścia są pisane na nowo.</translation>
    </message>
    <message>
        <source>Grid of X</source>
        <translation>Siatka X</translation>
    </message>
    <message>
        <source>Digits of the written program, on diameter.</source>
        <translation>Cyfry pisanego programu, na średnicy.</translation>
    </message>
    <message>
        <source>Residual allowed</source>
        <translation>Dopuszczalna reszta</translation>
    </message>
    <message>
        <source>What the written program may leave, on diameter.</source>
        <translation>Co pisany program może zostawić, na średnicy.</translation>
    </message>
    <message>
        <source>Largest correction</source>
        <translation>Największa korekcja</translation>
    </message>
    <message>
        <source>On diameter; more is refused.</source>
        <translation>Na średnicy; większa jest odrzucana.</translation>
    </message>
    <message>
        <source>Robustness</source>
        <translation>Odporność</translation>
    </message>
    <message>
        <source>Try the corrected program with other springs and forces.</source>
        <translation>Wypróbuj skorygowany program przy innych sztywnościach i siłach.</translation>
    </message>
    <message>
        <source>Tailstock 20 % stiffer</source>
        <translation>Konik o 20 % sztywniejszy</translation>
    </message>
    <message>
        <source>Tailstock 20 % softer</source>
        <translation>Konik o 20 % podatniejszy</translation>
    </message>
    <message>
        <source>All springs 20 % stiffer</source>
        <translation>Wszystkie sprężyny o 20 % sztywniejsze</translation>
    </message>
    <message>
        <source>All springs 20 % softer</source>
        <translation>Wszystkie sprężyny o 20 % podatniejsze</translation>
    </message>
    <message>
        <source>Forces 20 % larger</source>
        <translation>Siły o 20 % większe</translation>
    </message>
    <message>
        <source>Forces 20 % smaller</source>
        <translation>Siły o 20 % mniejsze</translation>
    </message>
    <message>
        <source>Forces 20 % larger, springs 20 % softer</source>
        <translation>Siły o 20 % większe, sprężyny o 20 % podatniejsze</translation>
    </message>
    <message>
        <source>The cut runs to z = {z_mm} mm; the stock ends at the chuck face, z = {length_mm} mm.</source>
        <translation>Skrawanie sięga do z = {z_mm} mm; półfabrykat kończy się przy czole uchwytu, z = {length_mm} mm.</translation>
    </message>
    <message>
        <source>At z = {z_mm} mm a radius of {radius_mm} mm would be left; expected more than {least_mm} mm.</source>
        <translation>Przy z = {z_mm} mm zostałby promień {radius_mm} mm; oczekiwano więcej niż {least_mm} mm.</translation>
    </message>
    <message>
        <source>No feed move toward the chuck leaves a diameter: none meets the stock, or cuts toward the free end took it off again.</source>
        <translation>Żaden ruch roboczy w stronę uchwytu nie zostawia średnicy: nie trafia w półfabrykat albo skrawania w stronę wolnego końca zebrały ją potem.</translation>
    </message>
    <message>
        <source>Nothing holds the work: chuck, tailstock and rests together leave it free to move.</source>
        <translation>Nic nie trzyma przedmiotu: uchwyt, konik i podtrzymki razem zostawiają mu swobodę ruchu.</translation>
    </message>
    <message>
        <source>{found} steps along z would be needed; at most {maximum} are taken. Choose a longer step.</source>
        <translation>Potrzeba by {found} kroków wzdłuż z; przyjmuje się najwyżej {maximum}. Wybierz dłuższy krok.</translation>
    </message>
    <message>
        <source>At z = {z_mm} mm the work is pushed away by {deflection_mm} mm: more than its radius, or beyond what a linear beam means.</source>
        <translation>Przy z = {z_mm} mm przedmiot jest odpychany o {deflection_mm} mm: więcej niż jego promień albo poza zakresem belki liniowej.</translation>
    </message>
    <message>
        <source>At z = {z_mm} mm the correction would be {correction_um} µm on diameter; at most {maximum_um} µm are allowed.</source>
        <translation>Przy z = {z_mm} mm korekcja wyniosłaby {correction_um} µm na średnicy; dopuszczalne jest najwyżej {maximum_um} µm.</translation>
    </message>
    <message>
        <source>Blocks on a grid of {grid_um} µm leave {residual_um} µm on diameter; asked are {tolerance_um} µm.</source>
        <translation>Bloki na siatce {grid_um} µm zostawiają {residual_um} µm na średnicy; wymagane jest {tolerance_um} µm.</translation>
    </message>
    <message>
        <source>The corrected program makes {found} cuts through the stock, the original {expected}.</source>
        <translation>Skorygowany program wykonuje {found} przejść przez półfabrykat, oryginał {expected}.</translation>
    </message>
    <message>
        <source>The set-up names no stock. State a stock file.</source>
        <translation>Ustawienie nie podaje półfabrykatu. Podaj plik półfabrykatu.</translation>
    </message>
    <message>
        <source>{found} measured diameters do not determine {parameters} unknowns.</source>
        <translation>{found} zmierzonych średnic nie wyznacza {parameters} niewiadomych.</translation>
    </message>
    <message>
        <source>The diameter measured at z = {z_mm} mm lies where nothing is cut; expected {from_mm} to {to_mm} mm.</source>
        <translation>Średnica zmierzona przy z = {z_mm} mm leży tam, gdzie nic nie jest skrawane; oczekiwano od {from_mm} do {to_mm} mm.</translation>
    </message>
    <message>
        <source>Line {line}, from z = {z_mm} mm: the depth of cut is no more than the scallop of {scallop_um} µm; no force is taken there, though the edge rubs.</source>
        <translation>Wiersz {line}, od z = {z_mm} mm: głębokość skrawania nie przekracza wysokości grzbietu {scallop_um} µm; siły się tam nie przyjmuje, choć krawędź trze.</translation>
    </message>
    <message>
        <source>Line {line}: a cut toward the free end is not predicted; its material is removed, and what it leaves is not judged.</source>
        <translation>Wiersz {line}: skrawania w stronę wolnego końca nie przewiduje się; jego materiał jest usuwany, a tego, co zostawia, nie ocenia się.</translation>
    </message>
    <message>
        <source>Line {line}: the tool plunges at z = {z_mm} mm; neither force nor groove of that is modelled.</source>
        <translation>Wiersz {line}: narzędzie wcina się przy z = {z_mm} mm; ani siła, ani rowek nie są modelowane.</translation>
    </message>
    <message>
        <source>Line {line}: the contour slopes by {slope_deg}°; depths are radial and the entering angle is that to the axis. Choose depths normal to the contour for slopes.</source>
        <translation>Wiersz {line}: kontur jest nachylony o {slope_deg}°; głębokości są promieniowe, a kąt przystawienia liczony do osi. Dla pochyleń wybierz głębokości normalne do konturu.</translation>
    </message>
    <message>
        <source>Line {line}: a slope of {slope_deg}° is steeper than the edge can follow; taken as {used_deg}°.</source>
        <translation>Wiersz {line}: nachylenie {slope_deg}° jest bardziej strome, niż krawędź może przejść; przyjęto {used_deg}°.</translation>
    </message>
    <message>
        <source>Axial and torsional stiffness are read; they never change a diameter.</source>
        <translation>Sztywność osiowa i skrętna są odczytane; nigdy nie zmieniają średnicy.</translation>
    </message>
    <message>
        <source>The work is pushed away by up to {deflection_mm} mm, at z = {z_mm} mm: chatter or lifting will come first.</source>
        <translation>Przedmiot jest odpychany nawet o {deflection_mm} mm, przy z = {z_mm} mm: wcześniej wystąpią drgania lub wysunięcie.</translation>
    </message>
    <message>
        <source>Line {line}: the passes of a thread are neither predicted nor corrected.</source>
        <translation>Wiersz {line}: przejścia gwintu nie są ani przewidywane, ani korygowane.</translation>
    </message>
    <message>
        <source>The program cuts with {count} tools; the forces are those of the one tool in the set-up.</source>
        <translation>Program skrawa {count} narzędziami; siły są siłami jedynego narzędzia z ustawienia.</translation>
    </message>
    <message>
        <source>Line {line}: a feed per minute without a spindle speed says no feed per revolution; such a cut cannot be predicted.</source>
        <translation>Wiersz {line}: posuw na minutę bez prędkości wrzeciona nie mówi, jaki jest posuw na obrót; takiego skrawania nie można przewidzieć.</translation>
    </message>
    <message>
        <source>{found} measured diameters do not determine {expected} unknown stiffnesses; none was sought.</source>
        <translation>{found} zmierzonych średnic nie wyznacza {expected} nieznanych sztywności; żadnej nie szukano.</translation>
    </message>
    <message>
        <source>The corrected contour is up to {correction_um} µm on diameter smaller than programmed.</source>
        <translation>Skorygowany kontur jest mniejszy od zaprogramowanego nawet o {correction_um} µm na średnicy.</translation>
    </message>
    <message>
        <source>The written program leaves {residual_um} µm on diameter; asked are {tolerance_um} µm.</source>
        <translation>Napisany program zostawia {residual_um} µm na średnicy; wymagane jest {tolerance_um} µm.</translation>
    </message>
    <message>
        <source>The measured diameters hardly determine {parameter}: its standard uncertainty is {uncertainty_percent} %.</source>
        <translation>Zmierzone średnice ledwie wyznaczają {parameter}: niepewność standardowa wynosi {uncertainty_percent} %.</translation>
    </message>
    <message>
        <source>{parameter} ran to the end of its range at {value} times its start: it may have no influence.</source>
        <translation>{parameter}: wartość doszła do końca zakresu, {value} razy początkowa; być może nie ma wpływu.</translation>
    </message>
    <message>
        <source>From z = {z_mm} mm the tolerance of {tolerance_um} µm cannot be held by the feed alone, not even at {feed_mm_rev} mm per revolution.</source>
        <translation>Od z = {z_mm} mm samym posuwem nie da się utrzymać tolerancji {tolerance_um} µm, nawet przy {feed_mm_rev} mm na obrót.</translation>
    </message>
    <message>
        <source>pass {pass}, line {line}</source>
        <translation>przejście {pass}, wiersz {line}</translation>
    </message>
    <message>
        <source>Diameter error along the work</source>
        <translation>Błąd średnicy wzdłuż przedmiotu</translation>
    </message>
    <message>
        <source>Diameter error</source>
        <translation>Błąd średnicy</translation>
    </message>
    <message>
        <source>95 % of the samples</source>
        <translation>95 % próbek</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>przewidywany</translation>
    </message>
    <message>
        <source>corrected program</source>
        <translation>program skorygowany</translation>
    </message>
    <message>
        <source>Cutting forces</source>
        <translation>Siły skrawania</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Siła</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>F_t, along the cutting speed</source>
        <translation>F_t, wzdłuż prędkości skrawania</translation>
    </message>
    <message>
        <source>F_f, along the feed</source>
        <translation>F_f, wzdłuż posuwu</translation>
    </message>
    <message>
        <source>F_ap, radial</source>
        <translation>F_ap, promieniowa</translation>
    </message>
    <message>
        <source>Cutting power</source>
        <translation>Moc skrawania</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Moc</translation>
    </message>
    <message>
        <source>kW</source>
        <translation>kW</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Głębokość</translation>
    </message>
    <message>
        <source>Bent axis of the work</source>
        <translation>Wygięta oś przedmiotu</translation>
    </message>
    <message>
        <source>toward the tool</source>
        <translation>w stronę narzędzia</translation>
    </message>
    <message>
        <source>along the cutting speed</source>
        <translation>wzdłuż prędkości skrawania</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>narzędzie</translation>
    </message>
    <message>
        <source>Correction of the program</source>
        <translation>Korekcja programu</translation>
    </message>
    <message>
        <source>Correction on diameter</source>
        <translation>Korekcja na średnicy</translation>
    </message>
    <message>
        <source>pass {pass}</source>
        <translation>przejście {pass}</translation>
    </message>
    <message>
        <source>Largest diameter error over depth and feed</source>
        <translation>Największy błąd średnicy w funkcji głębokości i posuwu</translation>
    </message>
    <message>
        <source>Largest diameter error</source>
        <translation>Największy błąd średnicy</translation>
    </message>
    <message>
        <source>Mean size of the diameter error</source>
        <translation>Średnia wielkość błędu średnicy</translation>
    </message>
    <message>
        <source>Range of the diameter error</source>
        <translation>Rozstęp błędu średnicy</translation>
    </message>
    <message>
        <source>Offset of X on diameter that leaves least</source>
        <translation>Przesunięcie X na średnicy, które zostawia najmniej</translation>
    </message>
    <message>
        <source>Length of the stock</source>
        <translation>Długość półfabrykatu</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Wiersz</translation>
    </message>
    <message>
        <source>Added</source>
        <translation>Dodany</translation>
    </message>
    <message>
        <source>Radius to program</source>
        <translation>Promień do zaprogramowania</translation>
    </message>
    <message>
        <source>Radius programmed</source>
        <translation>Promień zaprogramowany</translation>
    </message>
    <message>
        <source>Deflection toward the tool</source>
        <translation>Ugięcie w stronę narzędzia</translation>
    </message>
    <message>
        <source>Deflection along the cutting speed</source>
        <translation>Ugięcie wzdłuż prędkości skrawania</translation>
    </message>
    <message>
        <source>F_t</source>
        <translation>F_t</translation>
    </message>
    <message>
        <source>F_f</source>
        <translation>F_f</translation>
    </message>
    <message>
        <source>F_ap</source>
        <translation>F_ap</translation>
    </message>
    <message>
        <source>Stiffness at the tool</source>
        <translation>Sztywność przy narzędziu</translation>
    </message>
    <message>
        <source>Machine and work</source>
        <translation>Maszyna i przedmiot</translation>
    </message>
    <message>
        <source>Mean error before</source>
        <translation>Średni błąd przed</translation>
    </message>
    <message>
        <source>Mean error after</source>
        <translation>Średni błąd po</translation>
    </message>
    <message>
        <source>Largest error after</source>
        <translation>Największy błąd po</translation>
    </message>
    <message>
        <source>Reduction</source>
        <translation>Zmniejszenie</translation>
    </message>
    <message>
        <source>Blocks changed</source>
        <translation>Bloki zmienione</translation>
    </message>
    <message>
        <source>Blocks added</source>
        <translation>Bloki dodane</translation>
    </message>
    <message>
        <source>Largest correction on diameter</source>
        <translation>Największa korekcja na średnicy</translation>
    </message>
    <message>
        <source>Largest error of the written program</source>
        <translation>Największy błąd napisanego programu</translation>
    </message>
    <message>
        <source>Mean error of the written program</source>
        <translation>Średni błąd napisanego programu</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parametr</translation>
    </message>
    <message>
        <source>Factor</source>
        <translation>Współczynnik</translation>
    </message>
    <message>
        <source>Standard uncertainty</source>
        <translation>Niepewność standardowa</translation>
    </message>
    <message>
        <source>Measured error</source>
        <translation>Zmierzony błąd</translation>
    </message>
    <message>
        <source>Predicted before</source>
        <translation>Przewidywany przed</translation>
    </message>
    <message>
        <source>Predicted after</source>
        <translation>Przewidywany po</translation>
    </message>
    <message>
        <source>Uncertainty of the prediction</source>
        <translation>Niepewność przewidywania</translation>
    </message>
    <message>
        <source>E_n</source>
        <translation>E_n</translation>
    </message>
    <message>
        <source>Left before (rms)</source>
        <translation>Reszta przed (rms)</translation>
    </message>
    <message>
        <source>Left after (rms)</source>
        <translation>Reszta po (rms)</translation>
    </message>
    <message>
        <source>Largest error with these feeds</source>
        <translation>Największy błąd z tymi posuwami</translation>
    </message>
    <message>
        <source>Time by that of the program</source>
        <translation>Czas względem czasu programu</translation>
    </message>
    <message>
        <source>Influence</source>
        <translation>Wpływ</translation>
    </message>
    <message>
        <source>Largest error at -10 %</source>
        <translation>Największy błąd przy -10 %</translation>
    </message>
    <message>
        <source>Largest error at +10 %</source>
        <translation>Największy błąd przy +10 %</translation>
    </message>
    <message>
        <source>Mean error at -10 %</source>
        <translation>Średni błąd przy -10 %</translation>
    </message>
    <message>
        <source>Mean error at +10 %</source>
        <translation>Średni błąd przy +10 %</translation>
    </message>
    <message>
        <source>Largest error, least of 95 %</source>
        <translation>Największy błąd, dół 95 %</translation>
    </message>
    <message>
        <source>Largest error, most of 95 %</source>
        <translation>Największy błąd, góra 95 %</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Próbki</translation>
    </message>
    <message>
        <source>Cause</source>
        <translation>Przyczyna</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>Leaves (rms)</source>
        <translation>Zostawia (rms)</translation>
    </message>
    <message>
        <source>Measured errors (rms)</source>
        <translation>Zmierzone błędy (rms)</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Przesunięcie</translation>
    </message>
    <message>
        <source>Taper at the free end</source>
        <translation>Stożek na wolnym końcu</translation>
    </message>
    <message>
        <source>Factor on the deflection</source>
        <translation>Współczynnik ugięcia</translation>
    </message>
    <message>
        <source>Changed blocks</source>
        <translation>Zmienione bloki</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
    <message>
        <source>added</source>
        <translation>dodany</translation>
    </message>
    <message>
        <source>mean {mean} µm · range {range} µm · least with X moved by {offset} µm on diameter</source>
        <translation>średnio {mean} µm · rozstęp {range} µm · najmniej po przesunięciu X o {offset} µm na średnicy</translation>
    </message>
    <message>
        <source>Predicted diameter error</source>
        <translation>Przewidywany błąd średnicy</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korekcja</translation>
    </message>
    <message>
        <source>The corrected program on other machines</source>
        <translation>Skorygowany program na innych maszynach</translation>
    </message>
    <message>
        <source>Stiffness from measured diameters</source>
        <translation>Sztywność ze zmierzonych średnic</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Co znaleziono</translation>
    </message>
    <message>
        <source>Predicted and measured</source>
        <translation>Przewidywane i zmierzone</translation>
    </message>
    <message>
        <source>Deflection of the work</source>
        <translation>Ugięcie przedmiotu</translation>
    </message>
    <message>
        <source>Along the work</source>
        <translation>Wzdłuż przedmiotu</translation>
    </message>
    <message>
        <source>What if</source>
        <translation>Co, jeśli</translation>
    </message>
    <message>
        <source>Sensitivities</source>
        <translation>Wrażliwości</translation>
    </message>
    <message>
        <source>Two equal planes of a Timoshenko beam on springs; at each place the forces of the chip and the depth that the bent work leaves are brought to agree. Forces by chip area and length of the edge in cut, the flow of the chip by Colwell. Vibration, heat and wear are not in it.</source>
        <translation>Dwie równe płaszczyzny belki Timoszenki na sprężynach; w każdym miejscu uzgadnia się siły wióra z głębokością, którą zostawia wygięty przedmiot. Siły według pola warstwy i długości czynnej krawędzi, spływ wióra według Colwella. Drgań, ciepła i zużycia tu nie ma.</translation>
    </message>
    <message>
        <source>Diameter error of a slender shaft</source>
        <translation>Błąd średnicy smukłego wałka</translation>
    </message>
    <message>
        <source>Beams in closed form, relative</source>
        <translation>Belki w postaci zamkniętej, względnie</translation>
    </message>
    <message>
        <source>Of the diameter error, to both sides.</source>
        <translation>Błędu średnicy, w obie strony.</translation>
    </message>
    <message>
        <source>Least feed</source>
        <translation>Najmniejszy posuw</translation>
    </message>
    <message>
        <source>The edge rubs below.</source>
        <translation>Poniżej krawędź trze.</translation>
    </message>
    <message>
        <source>Largest feed</source>
        <translation>Największy posuw</translation>
    </message>
    <message>
        <source>Roughness and insert allow no more.</source>
        <translation>Chropowatość i płytka nie pozwalają na więcej.</translation>
    </message>
    <message>
        <source>As measured.</source>
        <translation>Jak zmierzono.</translation>
    </message>
    <message>
        <source>Of this diameter.</source>
        <translation>Tej średnicy.</translation>
    </message>
    <message>
        <source>Tailstock</source>
        <translation>Konik</translation>
    </message>
    <message>
        <source>Find its radial stiffness.</source>
        <translation>Znajdź jego sztywność promieniową.</translation>
    </message>
    <message>
        <source>Chuck, radial</source>
        <translation>Uchwyt, promieniowo</translation>
    </message>
    <message>
        <source>Chuck, tilting</source>
        <translation>Uchwyt, przechył</translation>
    </message>
    <message>
        <source>Find its tilting stiffness.</source>
        <translation>Znajdź jego sztywność na przechył.</translation>
    </message>
    <message>
        <source>Forces</source>
        <translation>Siły</translation>
    </message>
    <message>
        <source>Find one factor on all cutting forces.</source>
        <translation>Znajdź jeden współczynnik wszystkich sił skrawania.</translation>
    </message>
    <message>
        <source>Stiffness of the tailstock</source>
        <translation>Sztywność konika</translation>
    </message>
    <message>
        <source>Radial stiffness of the chuck</source>
        <translation>Sztywność promieniowa uchwytu</translation>
    </message>
    <message>
        <source>Tilting stiffness of the chuck</source>
        <translation>Sztywność uchwytu na przechył</translation>
    </message>
    <message>
        <source>Stiffness of the rests</source>
        <translation>Sztywność podtrzymek</translation>
    </message>
    <message>
        <source>Stiffness of the tool post</source>
        <translation>Sztywność imaka</translation>
    </message>
    <message>
        <source>Axial stiffness</source>
        <translation>Sztywność osiowa</translation>
    </message>
    <message>
        <source>Along the axis; changes no diameter.</source>
        <translation>Wzdłuż osi; nie zmienia średnicy.</translation>
    </message>
    <message>
        <source>Tilting stiffness</source>
        <translation>Sztywność na przechył</translation>
    </message>
    <message>
        <source>Against tilting of the axis.</source>
        <translation>Przeciw przechyleniu osi.</translation>
    </message>
    <message>
        <source>Torsional stiffness</source>
        <translation>Sztywność skrętna</translation>
    </message>
    <message>
        <source>About the axis; changes no diameter.</source>
        <translation>Wokół osi; nie zmienia średnicy.</translation>
    </message>
    <message>
        <source>Of the rest.</source>
        <translation>Podtrzymki.</translation>
    </message>
    <message>
        <source>Distance from the tool</source>
        <translation>Odległość od narzędzia</translation>
    </message>
    <message>
        <source>Toward the chuck; negative: behind the tool, on the machined surface.</source>
        <translation>W stronę uchwytu; ujemna: za narzędziem, na powierzchni obrobionej.</translation>
    </message>
    <message>
        <source>Of tool, turret and slide against being pushed out of the work.</source>
        <translation>Narzędzia, głowicy i suportu przeciw wypchnięciu z przedmiotu.</translation>
    </message>
    <message>
        <source>Tangential stiffness</source>
        <translation>Sztywność styczna</translation>
    </message>
    <message>
        <source>Of tool, turret and slide along the cutting speed.</source>
        <translation>Narzędzia, głowicy i suportu wzdłuż prędkości skrawania.</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Półfabrykat</translation>
    </message>
    <message>
        <source>File of the stock, relative to the set-up&apos;s file.</source>
        <translation>Plik półfabrykatu, względem pliku ustawienia.</translation>
    </message>
    <message>
        <source>z of the program&apos;s zero</source>
        <translation>Współrzędna z zera programu</translation>
    </message>
    <message>
        <source>z = this less the program&apos;s Z; 0: the program&apos;s zero is the free end.</source>
        <translation>z = ta wartość minus Z programu; 0: zero programu jest na wolnym końcu.</translation>
    </message>
    <message>
        <source>Of the work, with its cutting coefficients.</source>
        <translation>Przedmiotu, ze współczynnikami skrawania.</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Narzędzie</translation>
    </message>
    <message>
        <source>The insert.</source>
        <translation>Płytka.</translation>
    </message>
    <message>
        <source>Chuck</source>
        <translation>Uchwyt</translation>
    </message>
    <message>
        <source>Springs at the chuck face.</source>
        <translation>Sprężyny przy czole uchwytu.</translation>
    </message>
    <message>
        <source>Springs at the free end; none: not supported.</source>
        <translation>Sprężyny na wolnym końcu; brak: niepodparty.</translation>
    </message>
    <message>
        <source>Steady rests</source>
        <translation>Podtrzymki stałe</translation>
    </message>
    <message>
        <source>Rests that stand at one place.</source>
        <translation>Podtrzymki, które stoją w jednym miejscu.</translation>
    </message>
    <message>
        <source>Follower rest</source>
        <translation>Podtrzymka ruchoma</translation>
    </message>
    <message>
        <source>A rest that moves with the tool.</source>
        <translation>Podtrzymka, która przesuwa się z narzędziem.</translation>
    </message>
    <message>
        <source>Tool post</source>
        <translation>Imak narzędziowy</translation>
    </message>
    <message>
        <source>Stiffness of tool and turret in series with the work; none: rigid.</source>
        <translation>Sztywność narzędzia i głowicy szeregowo z przedmiotem; brak: sztywne.</translation>
    </message>
    <message>
        <source>Contact length</source>
        <translation>Długość styku</translation>
    </message>
    <message>
        <source>What counts as the edge in cut.</source>
        <translation>Co liczy się jako czynna krawędź.</translation>
    </message>
    <message>
        <source>Moment of the feed force</source>
        <translation>Moment siły posuwowej</translation>
    </message>
    <message>
        <source>The feed force bends the work, for it acts beside the axis.</source>
        <translation>Siła posuwowa zgina przedmiot, bo działa obok osi.</translation>
    </message>
    <message>
        <source>radial</source>
        <translation>promieniowo</translation>
    </message>
    <message>
        <source>normal to the contour</source>
        <translation>normalnie do konturu</translation>
    </message>
    <message>
        <source>Depth on slopes</source>
        <translation>Głębokość na pochyleniach</translation>
    </message>
    <message>
        <source>Depth and entering angle on cones and arcs: to the axis or to the contour.</source>
        <translation>Głębokość i kąt przystawienia na stożkach i łukach: do osi albo do konturu.</translation>
    </message>
    <message>
        <source>Longest step along z.</source>
        <translation>Najdłuższy krok wzdłuż z.</translation>
    </message>
    <message>
        <source>an object with material, tool and chuck</source>
        <translation>obiekt z materiałem, narzędziem i uchwytem</translation>
    </message>
    <message>
        <source>the material of the work</source>
        <translation>materiał przedmiotu</translation>
    </message>
    <message>
        <source>the insert</source>
        <translation>płytka</translation>
    </message>
    <message>
        <source>the springs of the chuck</source>
        <translation>sprężyny uchwytu</translation>
    </message>
    <message>
        <source>Set-ups</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>an offset: program or tool</source>
        <translation>przesunięcie: program albo narzędzie</translation>
    </message>
    <message>
        <source>a taper: tailstock or headstock out of line</source>
        <translation>stożek: konik lub wrzeciennik poza osią</translation>
    </message>
    <message>
        <source>the work gives way</source>
        <translation>przedmiot się ugina</translation>
    </message>
    <message>
        <source>it is an arc that runs beyond the work</source>
        <translation>to łuk, który wychodzi poza przedmiot</translation>
    </message>
    <message>
        <source>Largest at z = {z_mm:1} mm: {error:+1} µm on diameter</source>
        <translation>Największy przy z = {z_mm:1} mm: {error:+1} µm na średnicy</translation>
    </message>
    <message>
        <source>Repeat the prediction with springs, forces and modulus drawn at random; 95 % of the answers make a band.</source>
        <translation>Powtórz przewidywanie z losowanymi sprężynami, siłami i modułem; 95 % odpowiedzi tworzy pasmo.</translation>
    </message>
    <message>
        <source>What 10 % of each influence change.</source>
        <translation>Co zmienia 10 % każdego wpływu.</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Largest error over depth and feed of the last pass.</source>
        <translation>Największy błąd w funkcji głębokości i posuwu ostatniego przejścia.</translation>
    </message>
    <message>
        <source>Measured diameters</source>
        <translation>Zmierzone średnice</translation>
    </message>
    <message>
        <source>On the finished part: place, diameter, standard uncertainty.</source>
        <translation>Na gotowej części: miejsce, średnica, niepewność standardowa.</translation>
    </message>
    <message>
        <source>Predicting</source>
        <translation>Przewidywanie</translation>
    </message>
    <message>
        <source>Drawing samples</source>
        <translation>Losowanie próbek</translation>
    </message>
    <message>
        <source>Fitting</source>
        <translation>Dopasowywanie</translation>
    </message>
    <message>
        <source>Correcting</source>
        <translation>Korygowanie</translation>
    </message>
    <message>
        <source>Hangs most on: {influence} (±10 % change it by {swing:1} µm)</source>
        <translation>Najbardziej zależy od: {influence} (±10 % zmienia o {swing:1} µm)</translation>
    </message>
    <message>
        <source>Corrected program: {residual:2} µm left, {changed} blocks changed, {added} added</source>
        <translation>Skorygowany program: zostaje {residual:2} µm, zmienione bloki: {changed}, dodane: {added}</translation>
    </message>
    <message>
        <source>What was measured looks like: {cause}</source>
        <translation>To, co zmierzono, wygląda na: {cause}</translation>
    </message>
    <message>
        <source>What the measured diameters look like</source>
        <translation>Na co wyglądają zmierzone średnice</translation>
    </message>
    <message>
        <source>Least depth</source>
        <translation>Najmniejsza głębokość</translation>
    </message>
    <message>
        <source>Of the last pass.</source>
        <translation>Ostatniego przejścia.</translation>
    </message>
    <message>
        <source>Largest depth</source>
        <translation>Największa głębokość</translation>
    </message>
    <message>
        <source>Of the map.</source>
        <translation>Mapy.</translation>
    </message>
    <message>
        <source>Depths</source>
        <translation>Głębokości</translation>
    </message>
    <message>
        <source>In the map.</source>
        <translation>Na mapie.</translation>
    </message>
    <message>
        <source>Feeds</source>
        <translation>Posuwy</translation>
    </message>
    <message>
        <source>For the cycle time.</source>
        <translation>Do czasu cyklu.</translation>
    </message>
    <message>
        <source>Uncertainty of springs</source>
        <translation>Niepewność sprężyn</translation>
    </message>
    <message>
        <source>Standard, each by itself.</source>
        <translation>Standardowa, każdej z osobna.</translation>
    </message>
    <message>
        <source>Uncertainty of forces</source>
        <translation>Niepewność sił</translation>
    </message>
    <message>
        <source>Standard, all together.</source>
        <translation>Standardowa, wszystkich razem.</translation>
    </message>
    <message>
        <source>Uncertainty of the elastic modulus</source>
        <translation>Niepewność modułu sprężystości</translation>
    </message>
    <message>
        <source>Standard.</source>
        <translation>Standardowa.</translation>
    </message>
    <message>
        <source>Drawn for the band.</source>
        <translation>Losowane do pasma.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Ziarno</translation>
    </message>
    <message>
        <source>Of the random numbers.</source>
        <translation>Liczb losowych.</translation>
    </message>
    <message>
        <source>from the program</source>
        <translation>z programu</translation>
    </message>
    <message>
        <source>Fanuc, system A</source>
        <translation>Fanuc, system A</translation>
    </message>
    <message>
        <source>Haas</source>
        <translation>Haas</translation>
    </message>
    <message>
        <source>Sinumerik</source>
        <translation>Sinumerik</translation>
    </message>
    <message>
        <source>LinuxCNC</source>
        <translation>LinuxCNC</translation>
    </message>
    <message>
        <source>a name without its end</source>
        <translation>nazwa bez końca</translation>
    </message>
    <message>
        <source>no number of a variable</source>
        <translation>brak numeru zmiennej</translation>
    </message>
    <message>
        <source>no variable</source>
        <translation>brak zmiennej</translation>
    </message>
    <message>
        <source>a bracket is missing</source>
        <translation>brakuje nawiasu</translation>
    </message>
    <message>
        <source>a division by zero</source>
        <translation>dzielenie przez zero</translation>
    </message>
    <message>
        <source>it has no finite value</source>
        <translation>nie ma skończonej wartości</translation>
    </message>
    <message>
        <source>brackets nested too deep</source>
        <translation>nawiasy zagnieżdżone zbyt głęboko</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>brak liczby</translation>
    </message>
    <message>
        <source>a value is missing</source>
        <translation>brakuje wartości</translation>
    </message>
    <message>
        <source>an unknown function</source>
        <translation>nieznana funkcja</translation>
    </message>
    <message>
        <source>the root of a negative number</source>
        <translation>pierwiastek z liczby ujemnej</translation>
    </message>
    <message>
        <source>This program is written for {found}, which is not read; expected {expected}.</source>
        <translation>Program napisano dla: {found}, czego się nie czyta; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The program has {found_MiB} MiB; at most {most_MiB} are read.</source>
        <translation>Program ma {found_MiB} MiB; czyta się najwyżej {most_MiB}.</translation>
    </message>
    <message>
        <source>“{found}” begins no word of an NC program.</source>
        <translation>„{found}” nie zaczyna żadnego słowa programu NC.</translation>
    </message>
    <message>
        <source>Expected a number behind “{found}”.</source>
        <translation>Oczekiwano liczby za „{found}”.</translation>
    </message>
    <message>
        <source>The comment is not closed.</source>
        <translation>Komentarz nie jest zamknięty.</translation>
    </message>
    <message>
        <source>“{found}” cannot be computed: {reason}.</source>
        <translation>„{found}” nie da się obliczyć: {reason}.</translation>
    </message>
    <message>
        <source>A feed move without a feed: no F is in force.</source>
        <translation>Ruch roboczy bez posuwu: nie obowiązuje żadne F.</translation>
    </message>
    <message>
        <source>A position without a motion: none of G0, G1, G2, G3 is in force.</source>
        <translation>Położenie bez ruchu: nie obowiązuje żadne z G0, G1, G2, G3.</translation>
    </message>
    <message>
        <source>An arc needs its centre (I, K) or its radius.</source>
        <translation>Łuk wymaga środka (I, K) albo promienia.</translation>
    </message>
    <message>
        <source>The radius {radius_mm:4} mm does not reach: half of the chord is {half_chord_mm:4} mm.</source>
        <translation>Promień {radius_mm:4} mm nie sięga: połowa cięciwy to {half_chord_mm:4} mm.</translation>
    </message>
    <message>
        <source>The end of the arc lies {distance_mm:4} mm off the circle of radius {radius_mm:4} mm.</source>
        <translation>Koniec łuku leży {distance_mm:4} mm od okręgu o promieniu {radius_mm:4} mm.</translation>
    </message>
    <message>
        <source>The chamfer or rounding of {size_mm:4} mm does not fit between the two moves.</source>
        <translation>Faza lub zaokrąglenie {size_mm:4} mm nie mieści się między dwoma ruchami.</translation>
    </message>
    <message>
        <source>{cycle} cannot be run: {reason}.</source>
        <translation>{cycle} nie da się wykonać: {reason}.</translation>
    </message>
    <message>
        <source>The block {found} is not in the program.</source>
        <translation>Bloku {found} nie ma w programie.</translation>
    </message>
    <message>
        <source>The subprogram {found} is not in this file; what it does is not known.</source>
        <translation>Podprogramu {found} nie ma w tym pliku; nie wiadomo, co robi.</translation>
    </message>
    <message>
        <source>Subprograms or loops are nested more than {most} deep.</source>
        <translation>Podprogramy lub pętle są zagnieżdżone głębiej niż {most}.</translation>
    </message>
    <message>
        <source>More than {most} repetitions: the program does not seem to come to an end.</source>
        <translation>Ponad {most} powtórzeń: wygląda na to, że program się nie kończy.</translation>
    </message>
    <message>
        <source>The program makes more than {most} moves.</source>
        <translation>Program wykonuje więcej niż {most} ruchów.</translation>
    </message>
    <message>
        <source>“{found}” has no counterpart.</source>
        <translation>„{found}” nie ma odpowiednika.</translation>
    </message>
    <message>
        <source>The nose of radius {radius_mm:4} mm does not fit into this corner without a gouge.</source>
        <translation>Naroże o promieniu {radius_mm:4} mm nie wejdzie w ten kąt bez wcięcia w zarys.</translation>
    </message>
    <message>
        <source>The program stops itself here: {found}.</source>
        <translation>Program sam się tu zatrzymuje: {found}.</translation>
    </message>
    <message>
        <source>“{found}” contradicts another word of the same block.</source>
        <translation>„{found}” przeczy innemu słowu tego samego bloku.</translation>
    </message>
    <message>
        <source>“{found}”: expected {expected}.</source>
        <translation>„{found}”: oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The word “{found}” is not known; it is not modelled.</source>
        <translation>Słowo „{found}” jest nieznane; nie jest modelowane.</translation>
    </message>
    <message>
        <source>“{found}” is known, but what it does is not modelled.</source>
        <translation>„{found}” jest znane, ale jego działanie nie jest modelowane.</translation>
    </message>
    <message>
        <source>The block is not modelled because of “{found}”: its moves are missing.</source>
        <translation>Blok nie jest modelowany z powodu „{found}”: brakuje jego ruchów.</translation>
    </message>
    <message>
        <source>“{found}” has no decimal point; read as {read_as_mm:4} mm.</source>
        <translation>„{found}” nie ma kropki dziesiętnej; odczytano jako {read_as_mm:4} mm.</translation>
    </message>
    <message>
        <source>“{found}” replaces an earlier word of the same block.</source>
        <translation>„{found}” zastępuje wcześniejsze słowo tego samego bloku.</translation>
    </message>
    <message>
        <source>“{found}” has no use in this block.</source>
        <translation>„{found}” nie ma w tym bloku zastosowania.</translation>
    </message>
    <message>
        <source>The feed {found} was given in the other mode (per revolution, per minute).</source>
        <translation>Posuw {found} podano w innym trybie (na obrót, na minutę).</translation>
    </message>
    <message>
        <source>The program does not state {what}; assumed: {assumed}.</source>
        <translation>Program nie podaje: {what}; przyjęto: {assumed}.</translation>
    </message>
    <message>
        <source>The move starts from a position that is not known.</source>
        <translation>Ruch zaczyna się z nieznanego położenia.</translation>
    </message>
    <message>
        <source>“{found}” shifts the coordinates by an amount that the program does not state.</source>
        <translation>„{found}” przesuwa współrzędne o wielkość, której program nie podaje.</translation>
    </message>
    <message>
        <source>M99 in the main program starts it again; it is followed once.</source>
        <translation>M99 w programie głównym zaczyna go od nowa; śledzi się go raz.</translation>
    </message>
    <message>
        <source>Further places with {found}, not listed: {count}.</source>
        <translation>Dalsze miejsca z {found}, niewymienione: {count}.</translation>
    </message>
    <message>
        <source>“{found}” has no value here; read as 0.</source>
        <translation>„{found}” nie ma tu wartości; odczytano jako 0.</translation>
    </message>
    <message>
        <source>something is left behind it</source>
        <translation>coś zostało za nim</translation>
    </message>
    <message>
        <source>it has no words</source>
        <translation>nie ma słów</translation>
    </message>
    <message>
        <source>the height of the thread or its first cut is missing</source>
        <translation>brakuje wysokości gwintu lub pierwszego przejścia</translation>
    </message>
    <message>
        <source>one of the words P, I, J, K is missing</source>
        <translation>brakuje jednego ze słów P, I, J, K</translation>
    </message>
    <message>
        <source>P, J and K must be positive, and K not below J</source>
        <translation>P, J i K muszą być dodatnie, a K nie mniejsze niż J</translation>
    </message>
    <message>
        <source>it stands within the contour of a cycle</source>
        <translation>stoi w konturze cyklu</translation>
    </message>
    <message>
        <source>P and Q name its contour</source>
        <translation>P i Q wskazują jego kontur</translation>
    </message>
    <message>
        <source>the position where it starts is not known</source>
        <translation>położenie, w którym się zaczyna, nie jest znane</translation>
    </message>
    <message>
        <source>its contour has fewer than two moves</source>
        <translation>jego kontur ma mniej niż dwa ruchy</translation>
    </message>
    <message>
        <source>the depth of its passes is missing</source>
        <translation>brakuje głębokości jego przejść</translation>
    </message>
    <message>
        <source>diameter or radius</source>
        <translation>średnica czy promień</translation>
    </message>
    <message>
        <source>diameter (DIAMON)</source>
        <translation>średnica (DIAMON)</translation>
    </message>
    <message>
        <source>the kind of feed</source>
        <translation>rodzaj posuwu</translation>
    </message>
    <message>
        <source>mm per revolution (G95)</source>
        <translation>mm na obrót (G95)</translation>
    </message>
    <message>
        <source>a motion</source>
        <translation>ruch</translation>
    </message>
    <message>
        <source>G1</source>
        <translation>G1</translation>
    </message>
    <message>
        <source>G0</source>
        <translation>G0</translation>
    </message>
    <message>
        <source>bytes that are no text of an NC program</source>
        <translation>bajty, które nie są tekstem programu NC</translation>
    </message>
    <message>
        <source>a text with one byte for each character</source>
        <translation>tekst z jednym bajtem na znak</translation>
    </message>
    <message>
        <source>NC programs</source>
        <translation>Programy NC</translation>
    </message>
    <message>
        <source>nose radius compensation is active</source>
        <translation>czynna jest kompensacja promienia naroża</translation>
    </message>
    <message>
        <source>it belongs to the contour of a cycle</source>
        <translation>należy do konturu cyklu</translation>
    </message>
    <message>
        <source>a cycle makes its moves</source>
        <translation>jego ruchy wykonuje cykl</translation>
    </message>
    <message>
        <source>it is run more than once</source>
        <translation>jest wykonywany więcej niż raz</translation>
    </message>
    <message>
        <source>it is never run</source>
        <translation>nigdy nie jest wykonywany</translation>
    </message>
    <message>
        <source>its position is computed</source>
        <translation>jego położenie jest obliczane</translation>
    </message>
    <message>
        <source>a chamfer, a rounding or an angle shapes its end</source>
        <translation>jego koniec kształtuje faza, zaokrąglenie lub kąt</translation>
    </message>
    <message>
        <source>its position is not known</source>
        <translation>jego położenie nie jest znane</translation>
    </message>
    <message>
        <source>it has no place for an X word</source>
        <translation>nie ma miejsca na słowo X</translation>
    </message>
    <message>
        <source>it has no place for a Z word</source>
        <translation>nie ma miejsca na słowo Z</translation>
    </message>
    <message>
        <source>it is an arc without its own G word</source>
        <translation>to łuk bez własnego słowa G</translation>
    </message>
    <message>
        <source>it is an arc without its own G word, behind one that became straight</source>
        <translation>to łuk bez własnego słowa G za łukiem, który stał się prostą</translation>
    </message>
    <message>
        <source>it is an arc that begins at a changed X</source>
        <translation>to łuk, który zaczyna się w zmienionym X</translation>
    </message>
    <message>
        <source>T, P, D, Q (0 to 9) or an offset with a number</source>
        <translation>T, P, D, Q (0 do 9) albo przesunięcie z liczbą</translation>
    </message>
    <message>
        <source>a tool number T</source>
        <translation>numer narzędzia T</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Sterowanie</translation>
    </message>
    <message>
        <source>Language of the program.</source>
        <translation>Język programu.</translation>
    </message>
    <message>
        <source>Nose radius</source>
        <translation>Promień naroża</translation>
    </message>
    <message>
        <source>Of every tool, for G41 and G42.</source>
        <translation>Każdego narzędzia, dla G41 i G42.</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Ostrze</translation>
    </message>
    <message>
        <source>Where the imaginary tip lies seen from the nose centre, as Fanuc counts: 3 towards the axis and the chuck.</source>
        <translation>Gdzie leży umowny wierzchołek widziany ze środka naroża, jak liczy Fanuc: 3 w stronę osi i uchwytu.</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milimetry</translation>
    </message>
    <message>
        <source>micrometres</source>
        <translation>mikrometry</translation>
    </message>
    <message>
        <source>Numbers without a point</source>
        <translation>Liczby bez kropki</translation>
    </message>
    <message>
        <source>What X50 means to a Fanuc or Haas control: 50 mm or 50 µm.</source>
        <translation>Co X50 znaczy dla sterowania Fanuc lub Haas: 50 mm czy 50 µm.</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>Column</source>
        <translation>Kolumna</translation>
    </message>
    <message>
        <source>Severity</source>
        <translation>Waga</translation>
    </message>
    <message>
        <source>Block</source>
        <translation>Blok</translation>
    </message>
    <message>
        <source>error</source>
        <translation>błąd</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>ostrzeżenie</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>Dialect</source>
        <translation>Dialekt</translation>
    </message>
    <message>
        <source>Blocks</source>
        <translation>Bloki</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Słowa</translation>
    </message>
    <message>
        <source>Words understood</source>
        <translation>Słowa zrozumiane</translation>
    </message>
    <message>
        <source>Moves</source>
        <translation>Ruchy</translation>
    </message>
    <message>
        <source>Rapid moves</source>
        <translation>Ruchy szybkie</translation>
    </message>
    <message>
        <source>Feed moves</source>
        <translation>Ruchy robocze</translation>
    </message>
    <message>
        <source>Arcs</source>
        <translation>Łuki</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>Gwinty</translation>
    </message>
    <message>
        <source>NC program</source>
        <translation>Program NC</translation>
    </message>
    <message>
        <source>Set-up</source>
        <translation>Ustawienie</translation>
    </message>
    <message>
        <source>Machine, tool, material and stock, from SETUP.json.</source>
        <translation>Maszyna, narzędzie, materiał i półfabrykat, z SETUP.json.</translation>
    </message>
    <message>
        <source>A stock file or SHAFT.json, instead of the one in the set-up.</source>
        <translation>Plik półfabrykatu albo SHAFT.json, zamiast podanego w ustawieniu.</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>Nose radii from FILE, a tool table of LinuxCNC in mm.</source>
        <translation>Promienie naroży z PLIKU, tablicy narzędzi LinuxCNC w mm.</translation>
    </message>
    <message>
        <source>Following the program</source>
        <translation>Śledzenie programu</translation>
    </message>
    <message>
        <source>Lines kept</source>
        <translation>Wiersze bez zmian</translation>
    </message>
    <message>
        <source>Blocks of these lines stay as they are: 12:12, 20:31.</source>
        <translation>Bloki tych wierszy zostają, jak są: 12:12, 20:31.</translation>
    </message>
    <message>
        <source>{time:0} s in cut</source>
        <translation>{time:0} s skrawania</translation>
    </message>
    <message>
        <source>Depth of the last pass</source>
        <translation>Głębokość ostatniego przejścia</translation>
    </message>
    <message>
        <source>red: out of tolerance, blue: within</source>
        <translation>czerwone: poza tolerancją, niebieskie: w tolerancji</translation>
    </message>
    <message>
        <source>{error_um:1} µm</source>
        <translation>{error_um:1} µm</translation>
    </message>
    <message>
        <source>as programmed</source>
        <translation>jak zaprogramowano</translation>
    </message>
    <message>
        <source>ends where it ended, though the block before ends elsewhere</source>
        <translation>kończy się tam, gdzie się kończył, choć blok przed nim kończy się gdzie indziej</translation>
    </message>
    <message>
        <source>in air the path stays where it was</source>
        <translation>w powietrzu tor zostaje, gdzie był</translation>
    </message>
    <message>
        <source>{correction_um:+1} µm · dx {dx_um:+1} µm, dy {dy_um:+1} µm at z {z_mm:2} mm · F_t {F_t_N:0} N, F_ap {F_ap_N:0} N · {stiffness:0} N/mm</source>
        <translation>{correction_um:+1} µm · dx {dx_um:+1} µm, dy {dy_um:+1} µm przy z {z_mm:2} mm · F_t {F_t_N:0} N, F_ap {F_ap_N:0} N · {stiffness:0} N/mm</translation>
    </message>
    <message>
        <source>Drop an NC program and a set-up (SETUP.json) here: the corrected program follows.</source>
        <translation>Upuść tu program NC i ustawienie (SETUP.json): powstanie skorygowany program.</translation>
    </message>
    <message>
        <source>Drop an NC program and a set-up (SETUP.json) here: the error along the work follows.</source>
        <translation>Upuść tu program NC i ustawienie (SETUP.json): powstanie błąd wzdłuż przedmiotu.</translation>
    </message>
    <message>
        <source>The NC program that turns the work.</source>
        <translation>Program NC, który toczy przedmiot.</translation>
    </message>
    <message>
        <source>In place of the value in the set-up.</source>
        <translation>Zamiast wartości z ustawienia.</translation>
    </message>
    <message>
        <source>Tailstock, radial</source>
        <translation>Konik, promieniowo</translation>
    </message>
    <message>
        <source>Of those of the set-up.</source>
        <translation>Sił z ustawienia.</translation>
    </message>
    <message>
        <source>The tool meets what it must not meet, first in line {line}. Such moves: {count}.</source>
        <translation>Narzędzie trafia w to, w co nie może, najpierw w wierszu {line}. Takich ruchów: {count}.</translation>
    </message>
    <message>
        <source>The corrected program meets what it must not meet, first in line {line}. Such moves: {count}.</source>
        <translation>Skorygowany program trafia w to, w co nie może, najpierw w wierszu {line}. Takich ruchów: {count}.</translation>
    </message>
    <message>
        <source>The spindle is a table of receptances; the chuck stays that of the set-up.</source>
        <translation>Wrzeciono jest tabelą receptancji; uchwyt pozostaje ten z ustawienia.</translation>
    </message>
    <message>
        <source>Static compliance of the work before the first cut</source>
        <translation>Podatność statyczna przedmiotu przed pierwszym skrawaniem</translation>
    </message>
    <message>
        <source>Compliance</source>
        <translation>Podatność</translation>
    </message>
    <message>
        <source>by deflection</source>
        <translation>z ugięcia</translation>
    </message>
    <message>
        <source>receptance at 0 Hz</source>
        <translation>receptancja przy 0 Hz</translation>
    </message>
    <message>
        <source>Line {line}: {kind} at z = {z_mm:1} mm, {depth_mm:2} mm deep</source>
        <translation>Wiersz {line}: {kind} przy z = {z_mm:1} mm, na głębokość {depth_mm:2} mm</translation>
    </message>
    <message>
        <source>Check against the stock</source>
        <translation>Sprawdź względem półfabrykatu</translation>
    </message>
    <message>
        <source>Find rapid moves through stock, and where the tool meets chuck or tailstock.</source>
        <translation>Znajdź szybkie ruchy przez półfabrykat i miejsca, gdzie narzędzie trafia w uchwyt lub konik.</translation>
    </message>
    <message>
        <source>Checking against the stock</source>
        <translation>Sprawdzanie względem półfabrykatu</translation>
    </message>
    <message>
        <source>What the tool meets</source>
        <translation>Co trafia narzędzie</translation>
    </message>
    <message>
        <source>z of the chuck face</source>
        <translation>Współrzędna z czoła uchwytu</translation>
    </message>
    <message>
        <source>From the free end; empty: the end of the stock.</source>
        <translation>Od wolnego końca; puste: koniec półfabrykatu.</translation>
    </message>
    <message>
        <source>Radius of the jaws</source>
        <translation>Promień szczęk</translation>
    </message>
    <message>
        <source>0: everything beyond the chuck face is the chuck.</source>
        <translation>0: wszystko za czołem uchwytu jest uchwytem.</translation>
    </message>
    <message>
        <source>z of the supported end</source>
        <translation>Współrzędna z podpartego końca</translation>
    </message>
    <message>
        <source>Of the faced end that the centre stands in, from the free end of the stock.</source>
        <translation>Splanowanego końca, w którym tkwi kieł, od wolnego końca półfabrykatu.</translation>
    </message>
    <message>
        <source>Centre hole ⌀</source>
        <translation>⌀ nakiełka</translation>
    </message>
    <message>
        <source>Its largest diameter.</source>
        <translation>Jego największa średnica.</translation>
    </message>
    <message>
        <source>Angle of the centre</source>
        <translation>Kąt kła</translation>
    </message>
    <message>
        <source>Included.</source>
        <translation>Wierzchołkowy.</translation>
    </message>
    <message>
        <source>Quill ⌀</source>
        <translation>⌀ tulei</translation>
    </message>
    <message>
        <source>Of the body behind the centre.</source>
        <translation>Korpusu za kłem.</translation>
    </message>
    <message>
        <source>a small clearance</source>
        <translation>mały prześwit</translation>
    </message>
    <message>
        <source>a feed move above the stock</source>
        <translation>ruch roboczy nad półfabrykatem</translation>
    </message>
    <message>
        <source>The stock has no length.</source>
        <translation>Półfabrykat nie ma długości.</translation>
    </message>
    <message>
        <source>Segment {segment} of the stock cannot be: a negative or missing number, or an arc smaller than half its chord.</source>
        <translation>Odcinek {segment} półfabrykatu jest niemożliwy: liczba ujemna lub brakująca albo łuk mniejszy niż połowa jego cięciwy.</translation>
    </message>
    <message>
        <source>Tool {tool} cannot be: entering angle {entering_angle_deg}°, tip angle {tip_angle_deg}°, corner radius {corner_radius_mm} mm. Both angles together must stay below 180°, and the corner must fit between the edges.</source>
        <translation>Narzędzie {tool} jest niemożliwe: kąt przystawienia {entering_angle_deg}°, kąt wierzchołkowy {tip_angle_deg}°, promień naroża {corner_radius_mm} mm. Oba kąty razem muszą być mniejsze niż 180°, a naroże musi zmieścić się między krawędziami.</translation>
    </message>
    <message>
        <source>Line {line}, z = {z_mm} mm: a feed move above the stock cuts air over {length_mm} mm.</source>
        <translation>Wiersz {line}, z = {z_mm} mm: ruch roboczy nad półfabrykatem skrawa powietrze na długości {length_mm} mm.</translation>
    </message>
    <message>
        <source>Line {line}, z = {z_mm} mm: a rapid move passes the stock within 0.1 mm.</source>
        <translation>Wiersz {line}, z = {z_mm} mm: ruch szybki mija półfabrykat bliżej niż 0,1 mm.</translation>
    </message>
    <message>
        <source>Further places with {what}, not listed: {count}.</source>
        <translation>Dalsze miejsca z: {what}, niewymienione: {count}.</translation>
    </message>
    <message>
        <source>Line {line}: the move comes from a reference point whose place is not known; only its end is checked. Such moves: {count}.</source>
        <translation>Wiersz {line}: ruch zaczyna się w punkcie referencyjnym o nieznanym położeniu; sprawdza się tylko jego koniec. Takich ruchów: {count}.</translation>
    </message>
    <message>
        <source>The shape of tool {tool} is not fully stated; assumed are corner radius {corner_radius_mm} mm, entering angle {entering_angle_deg}°, tip angle {tip_angle_deg}°, reach {reach_mm} mm where they are missing.</source>
        <translation>Kształt narzędzia {tool} nie jest w pełni podany; tam, gdzie brakuje, przyjęto promień naroża {corner_radius_mm} mm, kąt przystawienia {entering_angle_deg}°, kąt wierzchołkowy {tip_angle_deg}°, wysięg {reach_mm} mm.</translation>
    </message>
    <message>
        <source>Tool {tool} has no stated holder: its insert alone is checked.</source>
        <translation>Narzędzie {tool} nie ma podanej oprawki: sprawdza się samą płytkę.</translation>
    </message>
    <message>
        <source>Length of the stock and number of moves widen the columns of the stock to {step_mm} mm (asked: {asked_mm} mm) and the steps of a feed move to {feed_step_mm} mm.</source>
        <translation>Długość półfabrykatu i liczba ruchów poszerzają kolumny półfabrykatu do {step_mm} mm (żądano: {asked_mm} mm), a kroki ruchu roboczego do {feed_step_mm} mm.</translation>
    </message>
    <message>
        <source>Line {line}: a thread is taken off down to its root, as if it had no flanks.</source>
        <translation>Wiersz {line}: gwint zdejmuje się do rdzenia, jakby nie miał boków.</translation>
    </message>
    <message>
        <source>Line {line}: tool {tool} feeds along the axis. It is not stated to be a drill; moves on the axis change no stock and are not checked against it.</source>
        <translation>Wiersz {line}: narzędzie {tool} posuwa się wzdłuż osi. Nie podano, że to wiertło; ruchy na osi nie zmieniają półfabrykatu i nie są z nim sprawdzane.</translation>
    </message>
    <message>
        <source>The stock is kept after every {every}th pass only; there are {passes}.</source>
        <translation>Półfabrykat zachowano tylko po co {every}. przejściu; jest ich {passes}.</translation>
    </message>
    <message>
        <source>By the numbers of the program.</source>
        <translation>Według numerów z programu.</translation>
    </message>
    <message>
        <source>What the tool must not meet; none: not checked.</source>
        <translation>W co narzędzie nie może trafić; brak: nie sprawdza się.</translation>
    </message>
    <message>
        <source>Centre and quill; none: not there.</source>
        <translation>Kieł i tuleja; brak: nie ma ich.</translation>
    </message>
    <message>
        <source>Dog-leg of rapid moves</source>
        <translation>Łamany tor ruchów szybkich</translation>
    </message>
    <message>
        <source>Test the path of a control that moves each axis at its own rate, too.</source>
        <translation>Sprawdź też tor sterowania, które przesuwa każdą oś z jej własną prędkością.</translation>
    </message>
    <message>
        <source>Rapid rate along x</source>
        <translation>Szybki przesuw wzdłuż x</translation>
    </message>
    <message>
        <source>Of the slide, on radius; the ratio of both rates shapes the dog-leg.</source>
        <translation>Suportu, na promieniu; tor łamany zależy od stosunku obu prędkości.</translation>
    </message>
    <message>
        <source>Rapid rate along z</source>
        <translation>Szybki przesuw wzdłuż z</translation>
    </message>
    <message>
        <source>Of the slide.</source>
        <translation>Suportu.</translation>
    </message>
    <message>
        <source>Column of stock</source>
        <translation>Kolumna półfabrykatu</translation>
    </message>
    <message>
        <source>Width along z; wider where stock or program are long.</source>
        <translation>Szerokość wzdłuż z; większa przy długim półfabrykacie lub programie.</translation>
    </message>
    <message>
        <source>Step of a feed move</source>
        <translation>Krok ruchu roboczego</translation>
    </message>
    <message>
        <source>Longest step between two tests of the holder.</source>
        <translation>Najdłuższy krok między dwoma sprawdzeniami oprawki.</translation>
    </message>
    <message>
        <source>Touching</source>
        <translation>Dotknięcie</translation>
    </message>
    <message>
        <source>What meets no deeper is no finding.</source>
        <translation>Co nie wchodzi głębiej, nie jest błędem.</translation>
    </message>
    <message>
        <source>rapid move through stock</source>
        <translation>szybki ruch przez półfabrykat</translation>
    </message>
    <message>
        <source>holder in stock</source>
        <translation>oprawka w półfabrykacie</translation>
    </message>
    <message>
        <source>tool in the chuck</source>
        <translation>narzędzie w uchwycie</translation>
    </message>
    <message>
        <source>tool in the tailstock</source>
        <translation>narzędzie w koniku</translation>
    </message>
    <message>
        <source>on the straight path</source>
        <translation>na torze prostym</translation>
    </message>
    <message>
        <source>on the dog-leg path</source>
        <translation>na torze łamanym</translation>
    </message>
    <message>
        <source>on both paths</source>
        <translation>na obu torach</translation>
    </message>
    <message>
        <source>feed moves</source>
        <translation>ruchy robocze</translation>
    </message>
    <message>
        <source>rapid moves</source>
        <translation>ruchy szybkie</translation>
    </message>
    <message>
        <source>Stock after each pass</source>
        <translation>Półfabrykat po każdym przejściu</translation>
    </message>
    <message>
        <source>stock before</source>
        <translation>półfabrykat przed</translation>
    </message>
    <message>
        <source>stock left</source>
        <translation>pozostały półfabrykat</translation>
    </message>
    <message>
        <source>chuck</source>
        <translation>uchwyt</translation>
    </message>
    <message>
        <source>tailstock</source>
        <translation>konik</translation>
    </message>
    <message>
        <source>line {line}: {finding}</source>
        <translation>wiersz {line}: {finding}</translation>
    </message>
    <message>
        <source>mm³</source>
        <translation>mm³</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Wykryty błąd</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Szerokość</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Tor</translation>
    </message>
    <message>
        <source>Removed</source>
        <translation>Usunięto</translation>
    </message>
    <message>
        <source>Volume of the stock</source>
        <translation>Objętość półfabrykatu</translation>
    </message>
    <message>
        <source>Removed by all passes</source>
        <translation>Usunięto we wszystkich przejściach</translation>
    </message>
    <message>
        <source>From the tip along z</source>
        <translation>Od ostrza wzdłuż z</translation>
    </message>
    <message>
        <source>Toward the chuck.</source>
        <translation>W stronę uchwytu.</translation>
    </message>
    <message>
        <source>From the tip along x</source>
        <translation>Od ostrza wzdłuż x</translation>
    </message>
    <message>
        <source>Away from the axis.</source>
        <translation>Od osi.</translation>
    </message>
    <message>
        <source>Tool number</source>
        <translation>Numer narzędzia</translation>
    </message>
    <message>
        <source>As the program calls it; 0: every tool that is not listed.</source>
        <translation>Jak nazywa je program; 0: każde niewymienione narzędzie.</translation>
    </message>
    <message>
        <source>insert with two edges</source>
        <translation>płytka o dwóch krawędziach</translation>
    </message>
    <message>
        <source>round insert</source>
        <translation>płytka okrągła</translation>
    </message>
    <message>
        <source>blade</source>
        <translation>przecinak</translation>
    </message>
    <message>
        <source>drill on the axis</source>
        <translation>wiertło na osi</translation>
    </message>
    <message>
        <source>What cuts.</source>
        <translation>Co skrawa.</translation>
    </message>
    <message>
        <source>Entering angle</source>
        <translation>Kąt przystawienia</translation>
    </message>
    <message>
        <source>Between main edge and feed: 90° less the lead angle.</source>
        <translation>Między główną krawędzią a posuwem: 90° minus kąt odchylenia.</translation>
    </message>
    <message>
        <source>Tip angle</source>
        <translation>Kąt naroża</translation>
    </message>
    <message>
        <source>Between both edges: C 80°, D 55°, V 35°; of a drill, its point.</source>
        <translation>Między obiema krawędziami: C 80°, D 55°, V 35°; wiertła: jego ostrza.</translation>
    </message>
    <message>
        <source>Length of the edge</source>
        <translation>Długość krawędzi</translation>
    </message>
    <message>
        <source>Width of the shank</source>
        <translation>Szerokość trzonka</translation>
    </message>
    <message>
        <source>A shank across the axis behind the insert; empty: the insert alone.</source>
        <translation>Trzonek w poprzek osi za płytką; puste: sama płytka.</translation>
    </message>
    <message>
        <source>Holder</source>
        <translation>Oprawka</translation>
    </message>
    <message>
        <source>Corners from the tip; their convex hull must not meet stock.</source>
        <translation>Naroża od ostrza; ich otoczka wypukła nie może trafić w półfabrykat.</translation>
    </message>
    <message>
        <source>Of insert and holder.</source>
        <translation>Płytki i oprawki.</translation>
    </message>
    <message>
        <source>Feed that holds the tolerance</source>
        <translation>Posuw, który utrzymuje tolerancję</translation>
    </message>
    <message>
        <source>feed of the last pass</source>
        <translation>posuw ostatniego przejścia</translation>
    </message>
    <message>
        <source>Feed along z</source>
        <translation>Posuw wzdłuż z</translation>
    </message>
    <message>
        <source>The feed that keeps the last pass within the tolerance, for those who may not change X.</source>
        <translation>Posuw, który utrzymuje ostatnie przejście w tolerancji, dla tych, którzy nie mogą zmienić X.</translation>
    </message>
    <message>
        <source>The stock states {stock_MPa} MPa for its elastic modulus, the set-up {setup_MPa} MPa; that of the set-up is used.</source>
        <translation>Półfabrykat podaje moduł sprężystości {stock_MPa} MPa, ustawienie {setup_MPa} MPa; użyto modułu z ustawienia.</translation>
    </message>
    <message>
        <source>Place and radial stiffness, in place of those in the set-up.</source>
        <translation>Miejsce i sztywność promieniowa, zamiast tych z ustawienia.</translation>
    </message>
    <message>
        <source>Follower rest, radial</source>
        <translation>Podtrzymka ruchoma, promieniowo</translation>
    </message>
    <message>
        <source>In place of the value in the set-up; 0: without one.</source>
        <translation>Zamiast wartości z ustawienia; 0: bez niej.</translation>
    </message>
    <message>
        <source>Follower rest, distance from the tool</source>
        <translation>Podtrzymka ruchoma, odległość od narzędzia</translation>
    </message>
    <message>
        <source>Tool post, radial</source>
        <translation>Zespół narzędziowy, promieniowo</translation>
    </message>
    <message>
        <source>In place of the value in the set-up; 0: rigid.</source>
        <translation>Zamiast wartości z ustawienia; 0: sztywny.</translation>
    </message>
    <message>
        <source>Tool post, tangential</source>
        <translation>Zespół narzędziowy, stycznie</translation>
    </message>
    <message>
        <source>The program was changed here and is not saved: the answer is that of the changed text.</source>
        <translation>Program został tu zmieniony i nie jest zapisany: odpowiedź dotyczy zmienionego tekstu.</translation>
    </message>
    <message>
        <source>More than {most} blocks are run: the program does not seem to come to an end.</source>
        <translation>Wykonywanych jest ponad {most} bloków: program zdaje się nie mieć końca.</translation>
    </message>
    <message>
        <source>Time in feed</source>
        <translation>Czas posuwu</translation>
    </message>
    <message>
        <source>Time in rapid</source>
        <translation>Czas ruchu szybkiego</translation>
    </message>
    <message>
        <source>Dwell</source>
        <translation>Postój</translation>
    </message>
    <message>
        <source>Way in feed</source>
        <translation>Droga posuwu</translation>
    </message>
    <message>
        <source>Way in rapid</source>
        <translation>Droga ruchu szybkiego</translation>
    </message>
    <message>
        <source>Feed moves without feed or speed</source>
        <translation>Ruchy robocze bez posuwu lub prędkości</translation>
    </message>
    <message>
        <source>Line {line}: {remark}</source>
        <translation>Wiersz {line}: {remark}</translation>
    </message>
    <message>
        <source>Running the program</source>
        <translation>Wykonywanie programu</translation>
    </message>
    <message>
        <source>Time of the program</source>
        <translation>Czas programu</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>✗ errors in the program</source>
        <translation>✗ błędy w programie</translation>
    </message>
    <message>
        <source>✓ the tool meets nothing it must not</source>
        <translation>✓ narzędzie na nic nie trafia</translation>
    </message>
    <message>
        <source>✗ the tool meets what it must not</source>
        <translation>✗ narzędzie trafia na przeszkodę</translation>
    </message>
    <message>
        <source>not checked against stock</source>
        <translation>bez sprawdzenia z półfabrykatem</translation>
    </message>
    <message>
        <source>errors: {errors} · remarks: {remarks} · {understood} of {words} words understood · in feed {feed} min over {way} mm</source>
        <translation>błędy: {errors} · uwagi: {remarks} · zrozumiane słowa: {understood} z {words} · posuwem {feed} min na {way} mm</translation>
    </message>
    <message>
        <source>Path of the tool and stock</source>
        <translation>Tor narzędzia i półfabrykat</translation>
    </message>
    <message>
        <source>Path of the tool</source>
        <translation>Tor narzędzia</translation>
    </message>
    <message>
        <source>z, from the program&apos;s zero toward the chuck</source>
        <translation>z, od zera programu do uchwytu</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Przejścia</translation>
    </message>
    <message>
        <source>Feed moves that state no feed or no speed are not in the time: {count}.</source>
        <translation>Ruchy robocze bez podanego posuwu lub prędkości nie są wliczone w czas: {count}.</translation>
    </message>
    <message>
        <source>Changed programs</source>
        <translation>Zmienione programy</translation>
    </message>
    <message>
        <source>Not saved yet.</source>
        <translation>Jeszcze niezapisane.</translation>
    </message>
    <message>
        <source>That was changed.</source>
        <translation>Który został zmieniony.</translation>
    </message>
    <message>
        <source>As changed.</source>
        <translation>Po zmianie.</translation>
    </message>
    <message>
        <source>Drop an NC program here: its path, its remarks and its time follow. With a set-up (SETUP.json) it is checked against the stock.</source>
        <translation>Upuść tu program NC: pokażą się jego tor, uwagi i czas. Z ustawieniem (SETUP.json) jest sprawdzany względem półfabrykatu.</translation>
    </message>
    <message>
        <source>Digest</source>
        <translation>Skrót</translation>
    </message>
    <message>
        <source>Of the file as it was read.</source>
        <translation>Pliku, jaki odczytano.</translation>
    </message>
    <message>
        <source>The geometry of the insert {insert} is taken from the library (source: {source}); the cutting coefficients stay those of the set-up.</source>
        <translation>Geometria płytki {insert} pochodzi z biblioteki (źródło: {source}); współczynniki skrawania zostają z ustawienia.</translation>
    </message>
    <message>
        <source>as the set-up states</source>
        <translation>jak podaje ustawienie</translation>
    </message>
    <message>
        <source>Insert</source>
        <translation>Płytka</translation>
    </message>
    <message>
        <source>Geometry from the library. The cutting coefficients, which belong to material and insert, stay those of the set-up.</source>
        <translation>Geometria z biblioteki. Współczynniki skrawania, które należą do materiału i płytki, zostają z ustawienia.</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maszyna</translation>
    </message>
    <message>
        <source>Expanded uncertainty, k = 2.</source>
        <translation>Niepewność rozszerzona, k = 2.</translation>
    </message>
    <message>
        <source>Of this kind of mark.</source>
        <translation>Dla tego rodzaju śladu.</translation>
    </message>
    <message>
        <source>Tolerance class</source>
        <translation>Klasa tolerancji</translation>
    </message>
    <message>
        <source>Of ISO 286-1, such as h6.</source>
        <translation>Według ISO 286-1, na przykład h6.</translation>
    </message>
    <message>
        <source>Deviation of the diameter.</source>
        <translation>Odchyłka średnicy.</translation>
    </message>
    <message>
        <source>U of its start</source>
        <translation>U początku</translation>
    </message>
    <message>
        <source>U of its end</source>
        <translation>U końca</translation>
    </message>
    <message>
        <source>U of its length</source>
        <translation>U długości</translation>
    </message>
    <message>
        <source>U of the start ⌀</source>
        <translation>U ⌀ początku</translation>
    </message>
    <message>
        <source>U of the end ⌀</source>
        <translation>U ⌀ końca</translation>
    </message>
    <message>
        <source>U of the radius</source>
        <translation>U promienia</translation>
    </message>
    <message>
        <source>U of the angle</source>
        <translation>U kąta</translation>
    </message>
    <message>
        <source>Measured length</source>
        <translation>Zmierzona długość</translation>
    </message>
    <message>
        <source>Measured start ⌀</source>
        <translation>Zmierzona ⌀ początku</translation>
    </message>
    <message>
        <source>Measured end ⌀</source>
        <translation>Zmierzona ⌀ końca</translation>
    </message>
    <message>
        <source>Measured radius</source>
        <translation>Zmierzony promień</translation>
    </message>
    <message>
        <source>Of the diameter.</source>
        <translation>Średnicy.</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Zmierzone</translation>
    </message>
    <message>
        <source>What a scan said of this row.</source>
        <translation>Co skan powiedział o tym wierszu.</translation>
    </message>
    <message>
        <source>At its end toward the mouth.</source>
        <translation>Na końcu od strony wylotu.</translation>
    </message>
    <message>
        <source>At its inner end.</source>
        <translation>Na końcu wewnętrznym.</translation>
    </message>
    <message>
        <source>free end</source>
        <translation>wolny koniec</translation>
    </message>
    <message>
        <source>chuck end</source>
        <translation>koniec w uchwycie</translation>
    </message>
    <message>
        <source>The end that its mouth is at.</source>
        <translation>Koniec, przy którym jest wylot.</translation>
    </message>
    <message>
        <source>From the mouth inward.</source>
        <translation>Od wylotu w głąb.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Rodzaj</translation>
    </message>
    <message>
        <source>Thread, knurl, keyway, flat…</source>
        <translation>Gwint, radełkowanie, rowek wpustowy, ścięcie…</translation>
    </message>
    <message>
        <source>Start z</source>
        <translation>z początku</translation>
    </message>
    <message>
        <source>End z</source>
        <translation>z końca</translation>
    </message>
    <message>
        <source>Floor from the axis</source>
        <translation>Dno od osi</translation>
    </message>
    <message>
        <source>Distance from the axis</source>
        <translation>Odległość od osi</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Podziałka</translation>
    </message>
    <message>
        <source>Crest ⌀</source>
        <translation>⌀ wierzchołków</translation>
    </message>
    <message>
        <source>Root ⌀</source>
        <translation>⌀ dna</translation>
    </message>
    <message>
        <source>Starts</source>
        <translation>Zwoje</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Kierunek</translation>
    </message>
    <message>
        <source>Teeth</source>
        <translation>Zęby</translation>
    </message>
    <message>
        <source>Helix angle</source>
        <translation>Kąt pochylenia</translation>
    </message>
    <message>
        <source>Designation</source>
        <translation>Oznaczenie</translation>
    </message>
    <message>
        <source>By its standard.</source>
        <translation>Według normy.</translation>
    </message>
    <message>
        <source>Bores</source>
        <translation>Otwory</translation>
    </message>
    <message>
        <source>One from each end at most.</source>
        <translation>Najwyżej jeden z każdego końca.</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Ślady</translation>
    </message>
    <message>
        <source>What is not a body of revolution.</source>
        <translation>Co nie jest bryłą obrotową.</translation>
    </message>
    <message>
        <source>General tolerance</source>
        <translation>Tolerancja ogólna</translation>
    </message>
    <message>
        <source>Such as ISO 2768-m.</source>
        <translation>Na przykład ISO 2768-m.</translation>
    </message>
    <message>
        <source>Row {row} of the {contour}: {quantity} is {found}; expected {expected}.</source>
        <translation>Wiersz {row}, {contour}: {quantity} = {found}; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>Row {row} of the {contour} crosses row {other_row} of the {other_contour} at z {z_mm} mm, ⌀ {diameter_mm} mm; a contour must not cross itself or a bore.</source>
        <translation>Wiersz {row}, {contour}, przecina wiersz {other_row}, {other_contour}, przy z {z_mm} mm, ⌀ {diameter_mm} mm; zarys nie może przecinać siebie ani otworu.</translation>
    </message>
    <message>
        <source>The bores meet: they are {free_mm} mm and {chuck_mm} mm deep, the part {length_mm} mm long; a through bore is one bore as long as the part.</source>
        <translation>Otwory się spotykają: mają głębokość {free_mm} mm i {chuck_mm} mm, a część długość {length_mm} mm; otwór przelotowy to jeden otwór tak długi jak część.</translation>
    </message>
    <message>
        <source>The shaft is not complete: {reason}. No drawing or CAD file is made of it.</source>
        <translation>Wał nie jest kompletny: {reason}. Nie powstaje z niego rysunek ani plik CAD.</translation>
    </message>
    <message>
        <source>Row {row} of the {contour} is {length_mm} mm long, less than 0.05 mm.</source>
        <translation>Wiersz {row}, {contour}, ma długość {length_mm} mm, mniej niż 0,05 mm.</translation>
    </message>
    <message>
        <source>Rows {row} and {other_row} of the {contour} are one line.</source>
        <translation>Wiersze {row} i {other_row}, {contour}, leżą na jednej linii.</translation>
    </message>
    <message>
        <source>The wall between outside and bore is {wall_mm} mm at z {z_mm} mm.</source>
        <translation>Ścianka między powierzchnią zewnętrzną a otworem ma {wall_mm} mm przy z {z_mm} mm.</translation>
    </message>
    <message>
        <source>The mark {kind} from z {z_start_mm} to {z_end_mm} mm lies on no single row of the shaft.</source>
        <translation>Ślad {kind} od z {z_start_mm} do {z_end_mm} mm nie leży na jednym wierszu wału.</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>powierzchnia zewnętrzna</translation>
    </message>
    <message>
        <source>bore from the free end</source>
        <translation>otwór od wolnego końca</translation>
    </message>
    <message>
        <source>bore from the chuck end</source>
        <translation>otwór od strony uchwytu</translation>
    </message>
    <message>
        <source>the length in mm</source>
        <translation>długość w mm</translation>
    </message>
    <message>
        <source>the start diameter in mm</source>
        <translation>średnica początku w mm</translation>
    </message>
    <message>
        <source>the end diameter in mm</source>
        <translation>średnica końca w mm</translation>
    </message>
    <message>
        <source>the arc radius in mm</source>
        <translation>promień łuku w mm</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>liczba skończona</translation>
    </message>
    <message>
        <source>the number of rows</source>
        <translation>liczba wierszy</translation>
    </message>
    <message>
        <source>one or more</source>
        <translation>jeden lub więcej</translation>
    </message>
    <message>
        <source>more than 0 inside the part</source>
        <translation>więcej niż 0 wewnątrz części</translation>
    </message>
    <message>
        <source>0 or more, but for the face of an undercut after a hollow arc</source>
        <translation>0 lub więcej, z wyjątkiem czoła podcięcia za łukiem wklęsłym</translation>
    </message>
    <message>
        <source>a finite number that is not 0</source>
        <translation>liczba skończona różna od 0</translation>
    </message>
    <message>
        <source>at least half the distance between the ends of the row</source>
        <translation>co najmniej połowa odległości między końcami wiersza</translation>
    </message>
    <message>
        <source>the length of the part in mm</source>
        <translation>długość części w mm</translation>
    </message>
    <message>
        <source>the bore diameter in mm</source>
        <translation>średnica otworu w mm</translation>
    </message>
    <message>
        <source>0 or more, below the diameters of its row</source>
        <translation>0 lub więcej, mniej niż średnice wiersza</translation>
    </message>
    <message>
        <source>There are no data from z {z_start_mm} to {z_end_mm} mm: the rows beside end there.</source>
        <translation>Od z {z_start_mm} do {z_end_mm} mm nie ma danych: sąsiednie wiersze tam się kończą.</translation>
    </message>
    <message>
        <source>The {end} of the part is not seen: the data end at z {z_mm} mm. The length is not known.</source>
        <translation>Nie widać końca części ({end}): dane kończą się przy z {z_mm} mm. Długość nie jest znana.</translation>
    </message>
    <message>
        <source>The length of {length_mm} mm was stated; the data alone do not show the {end}.</source>
        <translation>Długość {length_mm} mm została podana; same dane nie pokazują końca ({end}).</translation>
    </message>
    <message>
        <source>Row {row} (z {z_start_mm} to {z_end_mm} mm) lies {offset_mm} mm off the common axis.</source>
        <translation>Wiersz {row} (z od {z_start_mm} do {z_end_mm} mm) leży {offset_mm} mm od wspólnej osi.</translation>
    </message>
    <message>
        <source>Only {coverage_deg}° of the circle are seen: ovality of the part is taken for size; the uncertainties are wider by {added_um} µm.</source>
        <translation>Widać tylko {coverage_deg}° okręgu: owalność części liczy się jako wymiar; niepewności są większe o {added_um} µm.</translation>
    </message>
    <message>
        <source>The uncertainties hold the noise of the scan only; the scanner&apos;s own accuracy was not stated.</source>
        <translation>Niepewności obejmują tylko szum skanu; nie podano dokładności samego skanera.</translation>
    </message>
    <message>
        <source>From z {z_start_mm} to {z_end_mm} mm the surface is rough (a thread, a knurl): one row over its crests.</source>
        <translation>Od z {z_start_mm} do {z_end_mm} mm powierzchnia jest nierówna (gwint, radełkowanie): jeden wiersz po wierzchołkach.</translation>
    </message>
    <message>
        <source>Junctions within the form tolerance that were taken away: {count}.</source>
        <translation>Przejścia w granicach tolerancji kształtu, które usunięto: {count}.</translation>
    </message>
    <message>
        <source>The published method was used; its sections know no cones, arcs and undercuts.</source>
        <translation>Użyto metody opublikowanej; jej przekroje nie znają stożków, łuków ani podcięć.</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Oś</translation>
    </message>
    <message>
        <source>whole meridian, robust</source>
        <translation>cały zarys, odporna</translation>
    </message>
    <message>
        <source>The meridian fitted as a whole, or the sections of the published method.</source>
        <translation>Zarys osiowy dopasowany w całości albo przekroje metody opublikowanej.</translation>
    </message>
    <message>
        <source>suggest</source>
        <translation>proponuj</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>apply</source>
        <translation>zastosuj</translation>
    </message>
    <message>
        <source>Nominal sizes</source>
        <translation>Wymiary nominalne</translation>
    </message>
    <message>
        <source>Applied ones stand beside what was measured.</source>
        <translation>Zastosowane stoją obok zmierzonych.</translation>
    </message>
    <message>
        <source>Form tolerance</source>
        <translation>Tolerancja kształtu</translation>
    </message>
    <message>
        <source>On the radius: what one element describes within it is one row; 0: nothing is merged.</source>
        <translation>Na promieniu: co jeden element opisuje w jej granicach, jest jednym wierszem; 0: nic się nie łączy.</translation>
    </message>
    <message>
        <source>Of the maker; it is added to every uncertainty. Without it they hold noise only.</source>
        <translation>Według producenta; dodawana do każdej niepewności. Bez niej obejmują one tylko szum.</translation>
    </message>
    <message>
        <source>first of the data</source>
        <translation>początek danych</translation>
    </message>
    <message>
        <source>last of the data</source>
        <translation>koniec danych</translation>
    </message>
    <message>
        <source>Free end</source>
        <translation>Wolny koniec</translation>
    </message>
    <message>
        <source>Where z is 0, along the larger coordinate&apos;s sense.</source>
        <translation>Gdzie z = 0, w kierunku rosnącej większej współrzędnej.</translation>
    </message>
    <message>
        <source>Confirms the length where an end lies outside the scan.</source>
        <translation>Potwierdza długość, gdy koniec leży poza skanem.</translation>
    </message>
    <message>
        <source>Length in the chuck</source>
        <translation>Długość w uchwycie</translation>
    </message>
    <message>
        <source>Kept in the shaft, left out of the stock file.</source>
        <translation>Zostaje w wale, nie trafia do pliku półfabrykatu.</translation>
    </message>
    <message>
        <source>Section width</source>
        <translation>Szerokość przekroju</translation>
    </message>
    <message>
        <source>Of the published method.</source>
        <translation>Dla metody opublikowanej.</translation>
    </message>
    <message>
        <source>Sections cover</source>
        <translation>Przekroje pokrywają</translation>
    </message>
    <message>
        <source>Radial tolerance</source>
        <translation>Tolerancja promieniowa</translation>
    </message>
    <message>
        <source>the one before</source>
        <translation>poprzednim</translation>
    </message>
    <message>
        <source>the first of its step</source>
        <translation>pierwszym w stopniu</translation>
    </message>
    <message>
        <source>Sections are compared with</source>
        <translation>Przekroje porównuje się z</translation>
    </message>
    <message>
        <source>data</source>
        <translation>dane</translation>
    </message>
    <message>
        <source>mean of five bins</source>
        <translation>średnia z pięciu przedziałów</translation>
    </message>
    <message>
        <source>bore</source>
        <translation>otwór</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>brak danych</translation>
    </message>
    <message>
        <source>Data minus rows</source>
        <translation>Dane minus wiersze</translation>
    </message>
    <message>
        <source>Residual of the radius</source>
        <translation>Reszta promienia</translation>
    </message>
    <message>
        <source>±2 σ of a bin</source>
        <translation>±2 σ przedziału</translation>
    </message>
    <message>
        <source>form tolerance</source>
        <translation>tolerancja kształtu</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>stożek</translation>
    </message>
    <message>
        <source>arc</source>
        <translation>łuk</translation>
    </message>
    <message>
        <source>chamfer</source>
        <translation>faza</translation>
    </message>
    <message>
        <source>fillet</source>
        <translation>zaokrąglenie wewnętrzne</translation>
    </message>
    <message>
        <source>rounded edge</source>
        <translation>zaokrąglona krawędź</translation>
    </message>
    <message>
        <source>broken edge</source>
        <translation>stępiona krawędź</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>odsadzenie</translation>
    </message>
    <message>
        <source>groove</source>
        <translation>rowek</translation>
    </message>
    <message>
        <source>undercut</source>
        <translation>podcięcie</translation>
    </message>
    <message>
        <source>thread</source>
        <translation>gwint</translation>
    </message>
    <message>
        <source>knurl</source>
        <translation>radełkowanie</translation>
    </message>
    <message>
        <source>saddle</source>
        <translation>siodło</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>kula</translation>
    </message>
    <message>
        <source>keyway</source>
        <translation>rowek wpustowy</translation>
    </message>
    <message>
        <source>flat</source>
        <translation>ścięcie</translation>
    </message>
    <message>
        <source>cross hole</source>
        <translation>otwór poprzeczny</translation>
    </message>
    <message>
        <source>free form</source>
        <translation>kształt swobodny</translation>
    </message>
    <message>
        <source>face</source>
        <translation>czoło</translation>
    </message>
    <message>
        <source>round</source>
        <translation>zaokrąglenie</translation>
    </message>
    <message>
        <source>edge</source>
        <translation>krawędź</translation>
    </message>
    <message>
        <source>end of the data</source>
        <translation>koniec danych</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z od</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z do</translation>
    </message>
    <message>
        <source>Half angle</source>
        <translation>Kąt połówkowy</translation>
    </message>
    <message>
        <source>Seen of the circle</source>
        <translation>Widoczna część okręgu</translation>
    </message>
    <message>
        <source>Feature</source>
        <translation>Cecha</translation>
    </message>
    <message>
        <source>± (k = 2)</source>
        <translation>± (k = 2)</translation>
    </message>
    <message>
        <source>Closed by</source>
        <translation>Zamknięty przez</translation>
    </message>
    <message>
        <source>Bend</source>
        <translation>Załamanie</translation>
    </message>
    <message>
        <source>Row</source>
        <translation>Wiersz</translation>
    </message>
    <message>
        <source>Chamfer, start</source>
        <translation>Faza, początek</translation>
    </message>
    <message>
        <source>Chamfer, end</source>
        <translation>Faza, koniec</translation>
    </message>
    <message>
        <source>Its expanded uncertainty (k = 2)</source>
        <translation>Jej niepewność rozszerzona (k = 2)</translation>
    </message>
    <message>
        <source>Largest diameter</source>
        <translation>Największa średnica</translation>
    </message>
    <message>
        <source>Share of the length that rows cover</source>
        <translation>Część długości pokryta wierszami</translation>
    </message>
    <message>
        <source>Residual of the meridian (RMS)</source>
        <translation>Reszta zarysu osiowego (RMS)</translation>
    </message>
    <message>
        <source>χ² per bin</source>
        <translation>χ² na przedział</translation>
    </message>
    <message>
        <source>Width that edges are blurred by</source>
        <translation>Szerokość rozmycia krawędzi</translation>
    </message>
    <message>
        <source>Noise of single points</source>
        <translation>Szum pojedynczych punktów</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Objętość</translation>
    </message>
    <message>
        <source>Marks that are no body of revolution</source>
        <translation>Ślady, które nie są bryłą obrotową</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Ślad</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Wymiary</translation>
    </message>
    <message>
        <source>Features</source>
        <translation>Cechy</translation>
    </message>
    <message>
        <source>No data · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Brak danych · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Row {row}: form {form_um:1} µm · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Wiersz {row}: kształt {form_um:1} µm · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Nominal sizes suggested: {count}. Accept all</source>
        <translation>Proponowane wymiary nominalne: {count}. Przyjmij wszystkie</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>kompletny</translation>
    </message>
    <message>
        <source>not complete</source>
        <translation>niekompletny</translation>
    </message>
    <message>
        <source>Largest diameter {diameter_mm:3} mm ± {uncertainty_um:1} µm · {rows} rows</source>
        <translation>Największa średnica {diameter_mm:3} mm ± {uncertainty_um:1} µm · wierszy: {rows}</translation>
    </message>
    <message>
        <source>An end is not seen · largest diameter {diameter_mm:3} mm ± {uncertainty_um:1} µm · {rows} rows</source>
        <translation>Nie widać końca · największa średnica {diameter_mm:3} mm ± {uncertainty_um:1} µm · wierszy: {rows}</translation>
    </message>
    <message>
        <source>Rows from the free end, ± k = 2</source>
        <translation>Wiersze od wolnego końca, ± k = 2</translation>
    </message>
    <message>
        <source>Nominal</source>
        <translation>Nominał</translation>
    </message>
    <message>
        <source>R or half angle</source>
        <translation>R lub kąt połówkowy</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Kształt</translation>
    </message>
    <message>
        <source>Steps as published, chamfers folded in</source>
        <translation>Stopnie jak w publikacji, z fazami</translation>
    </message>
    <message>
        <source>Stretches without data</source>
        <translation>Odcinki bez danych</translation>
    </message>
    <message>
        <source>Recognised part</source>
        <translation>Rozpoznana część</translation>
    </message>
    <message>
        <source>Ends, steps and fit</source>
        <translation>Końce, stopnie i dopasowanie</translation>
    </message>
    <message>
        <source>Free end and chuck end</source>
        <translation>Wolny koniec i koniec w uchwycie</translation>
    </message>
    <message>
        <source>How well the rows describe the data</source>
        <translation>Jak dobrze wiersze opisują dane</translation>
    </message>
    <message>
        <source>Junctions within the form tolerance</source>
        <translation>Przejścia w granicach tolerancji kształtu</translation>
    </message>
    <message>
        <source>The points are gathered into bins of the meridian; lines and arcs with exact junctions are fitted to all bins at once. Uncertainties are expanded (k = 2). Measured values, not a specification.</source>
        <translation>Punkty zbiera się w przedziały zarysu osiowego; proste i łuki z dokładnymi przejściami dopasowuje się do wszystkich przedziałów naraz. Niepewności są rozszerzone (k = 2). To wartości zmierzone, nie wymagania.</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>Skan</translation>
    </message>
    <message>
        <source>Points or mesh of a turned part, in any pose</source>
        <translation>Punkty lub siatka części toczonej, w dowolnym położeniu</translation>
    </message>
    <message>
        <source>Drop the scan of a turned part here.</source>
        <translation>Upuść tu skan części toczonej.</translation>
    </message>
    <message>
        <source>Recognise</source>
        <translation>Rozpoznawanie</translation>
    </message>
    <message>
        <source>Recognising the rows</source>
        <translation>Rozpoznawanie wierszy</translation>
    </message>
    <message>
        <source>tapered stretch</source>
        <translation>odcinek zbieżny</translation>
    </message>
    <message>
        <source>No valid solid can be made of this shaft: {reason}.</source>
        <translation>Z tego wału nie da się zbudować poprawnej bryły: {reason}.</translation>
    </message>
    <message>
        <source>The solid made of this shaft has {found_mm3} mm³ instead of {expected_mm3} mm³; it is not written.</source>
        <translation>Bryła z tego wału ma {found_mm3} mm³ zamiast {expected_mm3} mm³; nie zostaje zapisana.</translation>
    </message>
    <message>
        <source>The STEP file holds no solid; wireframes and loose surfaces do not bound a part.</source>
        <translation>Plik STEP nie zawiera bryły; siatki krawędzi i luźne powierzchnie nie ograniczają części.</translation>
    </message>
    <message>
        <source>The STEP file holds several parts: {count} solids. One turned part is expected.</source>
        <translation>Plik STEP zawiera kilka części, liczba brył: {count}. Oczekiwano jednej części toczonej.</translation>
    </message>
    <message>
        <source>The STEP file has {found} {items}; at most {maximum} are read.</source>
        <translation>Plik STEP ma {found} ({items}); odczytuje się najwyżej {maximum}.</translation>
    </message>
    <message>
        <source>Row {row} of the contour is an arc whose centre lies beyond the axis: a surface of revolution in STEP, no torus.</source>
        <translation>Wiersz {row} zarysu jest łukiem o środku za osią: w STEP powierzchnia obrotowa, nie torus.</translation>
    </message>
    <message>
        <source>Faces that are not of revolution about the axis: {count}, {area_mm2} mm² of {total_mm2} mm²; the volume of the part is {volume_percent} % of the turned body&apos;s.</source>
        <translation>Ściany, które nie są obrotowe względem osi: {count}, {area_mm2} mm² z {total_mm2} mm²; objętość części to {volume_percent} % objętości bryły toczonej.</translation>
    </message>
    <message>
        <source>the end of a comment, “*/”</source>
        <translation>koniec komentarza „*/”</translation>
    </message>
    <message>
        <source>the number of a record from 1 to 1000000000</source>
        <translation>numer rekordu od 1 do 1000000000</translation>
    </message>
    <message>
        <source>the end of a text, a single quote</source>
        <translation>koniec tekstu, apostrof</translation>
    </message>
    <message>
        <source>another beginning</source>
        <translation>inny początek</translation>
    </message>
    <message>
        <source>a STEP file, which begins with “ISO-10303-21;”</source>
        <translation>plik STEP, który zaczyna się od „ISO-10303-21;”</translation>
    </message>
    <message>
        <source>a semicolon</source>
        <translation>średnik</translation>
    </message>
    <message>
        <source>HEADER</source>
        <translation>HEADER</translation>
    </message>
    <message>
        <source>an entry of the header or ENDSEC</source>
        <translation>wpis nagłówka albo ENDSEC</translation>
    </message>
    <message>
        <source>DATA</source>
        <translation>DATA</translation>
    </message>
    <message>
        <source>a record, “#…”, or ENDSEC</source>
        <translation>rekord „#…” albo ENDSEC</translation>
    </message>
    <message>
        <source>END-ISO-10303-21 after one section of data</source>
        <translation>END-ISO-10303-21 po jednej sekcji danych</translation>
    </message>
    <message>
        <source>each number of a record once</source>
        <translation>każdy numer rekordu jeden raz</translation>
    </message>
    <message>
        <source>“=” after the number of a record</source>
        <translation>„=” po numerze rekordu</translation>
    </message>
    <message>
        <source>at most 32 kinds in one record</source>
        <translation>najwyżej 32 rodzaje w jednym rekordzie</translation>
    </message>
    <message>
        <source>the kind of a record</source>
        <translation>rodzaj rekordu</translation>
    </message>
    <message>
        <source>“(”</source>
        <translation>„(”</translation>
    </message>
    <message>
        <source>lists no deeper than 16</source>
        <translation>listy zagnieżdżone najwyżej 16 razy</translation>
    </message>
    <message>
        <source>a comma or “)”</source>
        <translation>przecinek albo „)”</translation>
    </message>
    <message>
        <source>a value</source>
        <translation>wartość</translation>
    </message>
    <message>
        <source>a smaller whole number</source>
        <translation>mniejsza liczba całkowita</translation>
    </message>
    <message>
        <source>a smaller number</source>
        <translation>mniejsza liczba</translation>
    </message>
    <message>
        <source>the number of a record that is there</source>
        <translation>numer istniejącego rekordu</translation>
    </message>
    <message>
        <source>no ring of records that refer to each other</source>
        <translation>brak pierścienia rekordów, które wskazują na siebie</translation>
    </message>
    <message>
        <source>records no more than 200 deep</source>
        <translation>rekordy zagnieżdżone najwyżej 200 razy</translation>
    </message>
    <message>
        <source>a number in each row</source>
        <translation>liczba w każdym wierszu</translation>
    </message>
    <message>
        <source>at most 100000 rows</source>
        <translation>najwyżej 100000 wierszy</translation>
    </message>
    <message>
        <source>outside, bore_free or bore_chuck</source>
        <translation>outside, bore_free albo bore_chuck</translation>
    </message>
    <message>
        <source>the end of the step before</source>
        <translation>koniec poprzedniego stopnia</translation>
    </message>
    <message>
        <source>a step longer than its chamfers</source>
        <translation>stopień dłuższy niż jego fazy</translation>
    </message>
    <message>
        <source>the columns length_mm, start_diameter_mm and end_diameter_mm, or radius_mm, z_start_mm and z_end_mm</source>
        <translation>kolumny length_mm, start_diameter_mm i end_diameter_mm albo radius_mm, z_start_mm i z_end_mm</translation>
    </message>
    <message>
        <source>a record that does not fit</source>
        <translation>rekord, który nie pasuje</translation>
    </message>
    <message>
        <source>a record as its schema describes it</source>
        <translation>rekord zgodny ze swoim schematem</translation>
    </message>
    <message>
        <source>all its faces are planes</source>
        <translation>wszystkie jego ściany są płaszczyznami</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>płaszczyzna</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>torus</translation>
    </message>
    <message>
        <source>surface of revolution</source>
        <translation>powierzchnia obrotowa</translation>
    </message>
    <message>
        <source>free-form surface</source>
        <translation>powierzchnia swobodna</translation>
    </message>
    <message>
        <source>a piece of its contour makes no edge</source>
        <translation>odcinek zarysu nie tworzy krawędzi</translation>
    </message>
    <message>
        <source>an arc of its contour makes no edge</source>
        <translation>łuk zarysu nie tworzy krawędzi</translation>
    </message>
    <message>
        <source>its contour is not closed</source>
        <translation>zarys nie jest zamknięty</translation>
    </message>
    <message>
        <source>its contour bounds no area</source>
        <translation>zarys nie ogranicza pola</translation>
    </message>
    <message>
        <source>its contour cannot be revolved</source>
        <translation>zarysu nie da się obrócić</translation>
    </message>
    <message>
        <source>the revolved contour is no solid</source>
        <translation>obrócony zarys nie jest bryłą</translation>
    </message>
    <message>
        <source>the revolved contour is more than one solid</source>
        <translation>obrócony zarys to więcej niż jedna bryła</translation>
    </message>
    <message>
        <source>the revolved contour is not valid</source>
        <translation>obrócony zarys jest niepoprawny</translation>
    </message>
    <message>
        <source>the solid cannot be written as STEP</source>
        <translation>bryły nie da się zapisać jako STEP</translation>
    </message>
    <message>
        <source>Marks that are no body of revolution, named beside the rows: {count}.</source>
        <translation>Ślady, które nie są bryłą obrotową, podane obok wierszy: {count}.</translation>
    </message>
    <message>
        <source>z is drawn larger than the radius</source>
        <translation>z narysowano w większej skali niż promień</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Różnica</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Siatka</translation>
    </message>
    <message>
        <source>Chance</source>
        <translation>Szansa</translation>
    </message>
    <message>
        <source>Taper of the radius</source>
        <translation>Zbieżność promienia</translation>
    </message>
    <message>
        <source>Chamfer at its start</source>
        <translation>Faza na początku</translation>
    </message>
    <message>
        <source>Chamfer at its end</source>
        <translation>Faza na końcu</translation>
    </message>
    <message>
        <source>there is a gap in the data</source>
        <translation>w danych jest luka</translation>
    </message>
    <message>
        <source>Check only</source>
        <translation>Tylko sprawdzenie</translation>
    </message>
    <message>
        <source>Check the shaft and write nothing.</source>
        <translation>Sprawdza wał i niczego nie zapisuje.</translation>
    </message>
    <message>
        <source>Recognising</source>
        <translation>Rozpoznawanie</translation>
    </message>
    <message>
        <source>Schema of STEP</source>
        <translation>Schemat STEP</translation>
    </message>
    <message>
        <source>Application protocol that the STEP file names.</source>
        <translation>Protokół aplikacyjny podany w pliku STEP.</translation>
    </message>
    <message>
        <source>AP214</source>
        <translation>AP214</translation>
    </message>
    <message>
        <source>AP242</source>
        <translation>AP242</translation>
    </message>
    <message>
        <source>Contour as DXF</source>
        <translation>Zarys jako DXF</translation>
    </message>
    <message>
        <source>The closed half contour for CAM in place of the drawing.</source>
        <translation>Zamknięta połowa zarysu do CAM zamiast rysunku.</translation>
    </message>
    <message>
        <source>STEP files</source>
        <translation>Pliki STEP</translation>
    </message>
    <message>
        <source>knurl, {teeth} teeth</source>
        <translation>radełkowanie, zębów: {teeth}</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>General tolerances</source>
        <translation>Tolerancje ogólne</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Data</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Podziałka</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Arkusz</translation>
    </message>
    <message>
        <source>The bore is not seen from z {z_start_mm} to {z_end_mm} mm: its rows beside end there.</source>
        <translation>Otworu nie widać od z {z_start_mm} do {z_end_mm} mm: sąsiednie wiersze kończą się w tych miejscach.</translation>
    </message>
    <message>
        <source>SHAFT.json, a STEP file of a turned part, or what another panel made</source>
        <translation>SHAFT.json, plik STEP części toczonej albo wał z innego panelu</translation>
    </message>
    <message>
        <source>Drop a shaft here (SHAFT.json, STEP), or state its segments.</source>
        <translation>Upuść tu wał (SHAFT.json, STEP) albo podaj jego odcinki.</translation>
    </message>
    <message>
        <source>no remarks</source>
        <translation>bez uwag</translation>
    </message>
    <message>
        <source>with remarks</source>
        <translation>z uwagami</translation>
    </message>
    <message>
        <source>Mass {mass_kg:3} kg · largest diameter {diameter_mm:3} mm · {rows} rows</source>
        <translation>Masa {mass_kg:3} kg · największa średnica {diameter_mm:3} mm · wierszy: {rows}</translation>
    </message>
    <message>
        <source>Mass not known without a material · largest diameter {diameter_mm:3} mm · {rows} rows</source>
        <translation>Masa nieznana bez materiału · największa średnica {diameter_mm:3} mm · wierszy: {rows}</translation>
    </message>
    <message>
        <source>Rows from the free end</source>
        <translation>Wiersze od wolnego końca</translation>
    </message>
    <message>
        <source>There is nothing to remark on this shaft.</source>
        <translation>Brak uwag do tego wału.</translation>
    </message>
    <message>
        <source>Shaft for drawing and CAD</source>
        <translation>Wał do rysunku i CAD</translation>
    </message>
    <message>
        <source>Part name</source>
        <translation>Nazwa części</translation>
    </message>
    <message>
        <source>In the title block and in all files; empty: as the input has it.</source>
        <translation>W tabliczce rysunkowej i we wszystkich plikach; puste: jak w danych wejściowych.</translation>
    </message>
    <message>
        <source>Material name</source>
        <translation>Nazwa materiału</translation>
    </message>
    <message>
        <source>As printed in the title block; empty: the name of the material.</source>
        <translation>Tak jak w tabliczce rysunkowej; puste: nazwa materiału.</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A4 portrait</source>
        <translation>A4 pionowo</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Automatic: A4, or A3 where A4 would be too small to read.</source>
        <translation>Automatycznie: A4 albo A3, gdy A4 byłby za mały, żeby go odczytać.</translation>
    </message>
    <message>
        <source>As printed; empty: today.</source>
        <translation>Tak jak na rysunku; puste: dzisiejsza.</translation>
    </message>
    <message>
        <source>Measured values</source>
        <translation>Wartości zmierzone</translation>
    </message>
    <message>
        <source>Sizes in whose place no nominal one was put are set in italics.</source>
        <translation>Wymiary, których nie zastąpiono nominalnymi, są pisane kursywą.</translation>
    </message>
    <message>
        <source>The sizes of the copy were not recognised ({reason}): the rows have no measured values.</source>
        <translation>Nie rozpoznano wymiarów kopii ({reason}): wiersze nie mają wartości zmierzonych.</translation>
    </message>
    <message>
        <source>Bore</source>
        <translation>Otwór</translation>
    </message>
    <message>
        <source>U (k = 2)</source>
        <translation>U (k = 2)</translation>
    </message>
    <message>
        <source>Nominal sizes and fit of the rows</source>
        <translation>Wymiary nominalne i dopasowanie wierszy</translation>
    </message>
    <message>
        <source>Comparing the surface</source>
        <translation>Porównywanie powierzchni</translation>
    </message>
    <message>
        <source>Comparing the sizes</source>
        <translation>Porównywanie wymiarów</translation>
    </message>
    <message>
        <source>Verdicts</source>
        <translation>Werdykty</translation>
    </message>
    <message>
        <source>Together</source>
        <translation>Razem</translation>
    </message>
    <message>
        <source>Sizes against the drawing</source>
        <translation>Wymiary względem rysunku</translation>
    </message>
    <message>
        <source>Sizes of the rows</source>
        <translation>Wymiary wierszy</translation>
    </message>
    <message>
        <source>Comparison of a part with its drawing</source>
        <translation>Porównanie części z jej rysunkiem</translation>
    </message>
    <message>
        <source>diameter at the start</source>
        <translation>średnica na początku</translation>
    </message>
    <message>
        <source>diameter at the end</source>
        <translation>średnica na końcu</translation>
    </message>
    <message>
        <source>length</source>
        <translation>długość</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>promień</translation>
    </message>
    <message>
        <source>Bore {bore}, row {row}, {quantity}: not measured</source>
        <translation>Otwór {bore}, wiersz {row}, {quantity}: nie zmierzono</translation>
    </message>
    <message>
        <source>Row {row}, {quantity}: not measured</source>
        <translation>Wiersz {row}, {quantity}: nie zmierzono</translation>
    </message>
    <message>
        <source>Bore {bore}, row {row}, {quantity} {deviation_mm:+3} mm</source>
        <translation>Otwór {bore}, wiersz {row}, {quantity} {deviation_mm:+3} mm</translation>
    </message>
    <message>
        <source>Row {row}, {quantity} {deviation_mm:+3} mm</source>
        <translation>Wiersz {row}, {quantity} {deviation_mm:+3} mm</translation>
    </message>
    <message>
        <source>✓ sizes within tolerance</source>
        <translation>✓ wymiary w tolerancji</translation>
    </message>
    <message>
        <source>✗ sizes out of tolerance</source>
        <translation>✗ wymiary poza tolerancją</translation>
    </message>
    <message>
        <source>? sizes not decided</source>
        <translation>? wymiary nierozstrzygnięte</translation>
    </message>
    <message>
        <source>The part is not stated: neither a shaft was given nor does the job hold one.</source>
        <translation>Nie podano części: nie wskazano wałka ani nie zawiera go zadanie.</translation>
    </message>
    <message>
        <source>The part does not fit into the stock at z = {z_mm} mm: {missing_mm} mm of {quantity} are missing.</source>
        <translation>Część nie mieści się w półfabrykacie przy z = {z_mm} mm: brakuje {missing_mm} mm ({quantity}).</translation>
    </message>
    <message>
        <source>Segment {segment} of the part cannot be turned: {quantity} is {found}; expected {expected}.</source>
        <translation>Segmentu {segment} części nie da się toczyć: {quantity} wynosi {found}; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The number {tool} is that of two tools.</source>
        <translation>Numer {tool} mają dwa narzędzia.</translation>
    </message>
    <message>
        <source>Tool {tool} ({use}) does not state its {quantity}.</source>
        <translation>Narzędzie {tool} ({use}) nie podaje wielkości: {quantity}.</translation>
    </message>
    <message>
        <source>The job has no tool for {use}.</source>
        <translation>W zadaniu brak narzędzia do: {use}.</translation>
    </message>
    <message>
        <source>Blade {tool} reaches {reach_mm} mm; parting off needs {needed_mm} mm.</source>
        <translation>Przecinak {tool} sięga {reach_mm} mm; odcięcie wymaga {needed_mm} mm.</translation>
    </message>
    <message>
        <source>The job states no highest speed of the spindle.</source>
        <translation>Zadanie nie podaje największej prędkości obrotowej wrzeciona.</translation>
    </message>
    <message>
        <source>The job is that of the form, which was changed since {source} was opened.</source>
        <translation>Zadanie pochodzi z formularza, który zmieniono od otwarcia {source}.</translation>
    </message>
    <message>
        <source>Line {line}: tool {tool} is not in the job. What it leaves is not measured, and its shape is assumed.</source>
        <translation>Linia {line}: narzędzia {tool} nie ma w zadaniu. Tego, co zostawia, nie zmierzono, a jego kształt jest założony.</translation>
    </message>
    <message>
        <source>Where the chuck stands in the second clamping is not stated; it is not looked at.</source>
        <translation>Nie podano położenia uchwytu w drugim zamocowaniu; nie jest ono sprawdzane.</translation>
    </message>
    <message>
        <source>From z</source>
        <translation>Od z</translation>
    </message>
    <message>
        <source>To z</source>
        <translation>Do z</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Pozostało</translation>
    </message>
    <message>
        <source>Drawn radius</source>
        <translation>Promień na rysunku</translation>
    </message>
    <message>
        <source>Gouge</source>
        <translation>Wcięcie w zarys</translation>
    </message>
    <message>
        <source>z of the gouge</source>
        <translation>z podcięcia</translation>
    </message>
    <message>
        <source>Line of the gouge</source>
        <translation>Wiersz podcięcia</translation>
    </message>
    <message>
        <source>Most that is left</source>
        <translation>Największy naddatek pozostały</translation>
    </message>
    <message>
        <source>Left {left_mm:3} mm · z {from:2}-{to:2} mm · {cause}</source>
        <translation>Pozostało {left_mm:3} mm · z {from:2}-{to:2} mm · {cause}</translation>
    </message>
    <message>
        <source>Most that is left on the drawing</source>
        <translation>Największy naddatek pozostały względem rysunku</translation>
    </message>
    <message>
        <source>✗ material stays</source>
        <translation>✗ materiał pozostaje</translation>
    </message>
    <message>
        <source>✓ as drawn</source>
        <translation>✓ zgodnie z rysunkiem</translation>
    </message>
    <message>
        <source>gouge {gouge_um:2} µm · places with material left: {rest} · findings: {findings}</source>
        <translation>wcięcie w zarys {gouge_um:2} µm · miejsca z pozostałym materiałem: {rest} · wykryte błędy: {findings}</translation>
    </message>
    <message>
        <source>Drawing, stock and tool</source>
        <translation>Rysunek, półfabrykat i narzędzie</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>rysunek</translation>
    </message>
    <message>
        <source>What stays on the drawing</source>
        <translation>Co zostaje względem rysunku</translation>
    </message>
    <message>
        <source>Check of the program</source>
        <translation>Sprawdzenie programu</translation>
    </message>
    <message>
        <source>Check of a turning program</source>
        <translation>Kontrola programu toczenia</translation>
    </message>
    <message>
        <source>the corners that deflection --compensate states</source>
        <translation>naroża, które podaje deflection --compensate</translation>
    </message>
    <message>
        <source>nose radius</source>
        <translation>promień naroża</translation>
    </message>
    <message>
        <source>back angle</source>
        <translation>pomocniczy kąt przystawienia</translation>
    </message>
    <message>
        <source>entering angle</source>
        <translation>kąt przystawienia</translation>
    </message>
    <message>
        <source>holder</source>
        <translation>oprawka</translation>
    </message>
    <message>
        <source>not cut</source>
        <translation>nieobrobione</translation>
    </message>
    <message>
        <source>insert below the drawing</source>
        <translation>wstaw pod rysunkiem</translation>
    </message>
    <message>
        <source>Measuring the surface</source>
        <translation>Pomiar powierzchni</translation>
    </message>
    <message>
        <source>Clamping</source>
        <translation>Zamocowanie</translation>
    </message>
    <message>
        <source>2: the part is turned round, and z counts from its other end.</source>
        <translation>2: część jest odwrócona, a z liczy się od jej drugiego końca.</translation>
    </message>
    <message>
        <source>Finished from z</source>
        <translation>Wykończone od z</translation>
    </message>
    <message>
        <source>What is left counts from here; empty: from the free end.</source>
        <translation>Stąd liczy się to, co zostaje; puste: od wolnego końca.</translation>
    </message>
    <message>
        <source>Finished up to z</source>
        <translation>Wykończono do z</translation>
    </message>
    <message>
        <source>What is left counts up to here; empty: to the end of the part.</source>
        <translation>Naddatek pozostały liczy się do tego miejsca; puste: do końca części.</translation>
    </message>
    <message>
        <source>In this clamping; empty: as the job states for the first, not looked at in the second.</source>
        <translation>W tym zamocowaniu; puste: w pierwszym jak podaje zadanie, w drugim nie jest sprawdzane.</translation>
    </message>
    <message>
        <source>Dog-leg</source>
        <translation>Ruch łamany</translation>
    </message>
    <message>
        <source>Try the dog-leg of rapid moves besides the straight line.</source>
        <translation>Próbuj ruchów szybkich po linii łamanej oprócz linii prostej.</translation>
    </message>
    <message>
        <source>Specific cutting force</source>
        <translation>Właściwa siła skrawania</translation>
    </message>
    <message>
        <source>At a chip of 1 mm by 1 mm.</source>
        <translation>Przy wiórze 1 mm na 1 mm.</translation>
    </message>
    <message>
        <source>Exponent</source>
        <translation>Wykładnik</translation>
    </message>
    <message>
        <source>How the force falls with the thickness.</source>
        <translation>Jak siła maleje z grubością.</translation>
    </message>
    <message>
        <source>As drawings state it.</source>
        <translation>Tak jak podają rysunki.</translation>
    </message>
    <message>
        <source>Standing</source>
        <translation>Pozostaje</translation>
    </message>
    <message>
        <source>Given or assumed.</source>
        <translation>Podane lub przyjęte.</translation>
    </message>
    <message>
        <source>rpm</source>
        <translation>obr/min</translation>
    </message>
    <message>
        <source>roughing</source>
        <translation>obróbka zgrubna</translation>
    </message>
    <message>
        <source>finishing</source>
        <translation>wykańczanie</translation>
    </message>
    <message>
        <source>finishing from the chuck</source>
        <translation>wykańczanie od uchwytu</translation>
    </message>
    <message>
        <source>grooving</source>
        <translation>toczenie rowków</translation>
    </message>
    <message>
        <source>parting off</source>
        <translation>odcięcie</translation>
    </message>
    <message>
        <source>centre drilling</source>
        <translation>nakiełkowanie</translation>
    </message>
    <message>
        <source>Per revolution.</source>
        <translation>Na obrót.</translation>
    </message>
    <message>
        <source>Diameter of the bar</source>
        <translation>Średnica pręta</translation>
    </message>
    <message>
        <source>Before the first cut.</source>
        <translation>Przed pierwszym przejściem.</translation>
    </message>
    <message>
        <source>Length of the bar</source>
        <translation>Długość pręta</translation>
    </message>
    <message>
        <source>From its raw end; empty: up to the chuck face and into it.</source>
        <translation>Od jego surowego końca; puste: do czoła uchwytu i w głąb uchwytu.</translation>
    </message>
    <message>
        <source>Allowance of the face</source>
        <translation>Naddatek czoła</translation>
    </message>
    <message>
        <source>How far the raw end stands before the finished one.</source>
        <translation>O ile surowe czoło wystaje poza gotowe.</translation>
    </message>
    <message>
        <source>From the free end, negative beyond it.</source>
        <translation>Od wolnego końca, ujemne poza nim.</translation>
    </message>
    <message>
        <source>From the axis.</source>
        <translation>Od osi.</translation>
    </message>
    <message>
        <source>Outline of the tailstock</source>
        <translation>Zarys konika</translation>
    </message>
    <message>
        <source>Corners that the tool must keep out of; empty: a centre of 60°.</source>
        <translation>Naroża obszaru, w który narzędzie nie może wejść; puste: kieł 60°.</translation>
    </message>
    <message>
        <source>From the free end of the finished part.</source>
        <translation>Od wolnego końca gotowej części.</translation>
    </message>
    <message>
        <source>Jaws ⌀</source>
        <translation>⌀ szczęk</translation>
    </message>
    <message>
        <source>Empty: everything beyond the chuck face is the chuck.</source>
        <translation>Puste: wszystko za czołem uchwytu jest uchwytem.</translation>
    </message>
    <message>
        <source>Length of the grip</source>
        <translation>Długość zamocowania</translation>
    </message>
    <message>
        <source>The least length to be held; empty: not looked at.</source>
        <translation>Najmniejsza długość do zamocowania; puste: nie sprawdza się.</translation>
    </message>
    <message>
        <source>At the free end; none: free.</source>
        <translation>Na wolnym końcu; brak: swobodny.</translation>
    </message>
    <message>
        <source>As the program calls it.</source>
        <translation>Tak, jak wywołuje go program.</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>Użycie</translation>
    </message>
    <message>
        <source>What it is for.</source>
        <translation>Do czego służy.</translation>
    </message>
    <message>
        <source>Of an insert.</source>
        <translation>Płytki.</translation>
    </message>
    <message>
        <source>Margin of the back angle</source>
        <translation>Zapas pomocniczego kąta przystawienia</translation>
    </message>
    <message>
        <source>What a planned path keeps below the back angle.</source>
        <translation>O ile planowana ścieżka pozostaje poniżej pomocniczego kąta przystawienia.</translation>
    </message>
    <message>
        <source>toward the chuck</source>
        <translation>w stronę uchwytu</translation>
    </message>
    <message>
        <source>from the chuck</source>
        <translation>od uchwytu</translation>
    </message>
    <message>
        <source>Direction of its feed.</source>
        <translation>Kierunek jego posuwu.</translation>
    </message>
    <message>
        <source>Reach</source>
        <translation>Wysięg</translation>
    </message>
    <message>
        <source>Per revolution; empty: that of the cutting data.</source>
        <translation>Na obrót; puste: z parametrów skrawania.</translation>
    </message>
    <message>
        <source>The largest of a pass, on radius.</source>
        <translation>Największa w przejściu, na promieniu.</translation>
    </message>
    <message>
        <source>At the outer diameter.</source>
        <translation>Na średnicy zewnętrznej.</translation>
    </message>
    <message>
        <source>Allowance</source>
        <translation>Naddatek</translation>
    </message>
    <message>
        <source>Left for the finish, normal to the surface.</source>
        <translation>Pozostawione na wykończenie, prostopadle do powierzchni.</translation>
    </message>
    <message>
        <source>Of the work.</source>
        <translation>Przedmiotu obrabianego.</translation>
    </message>
    <message>
        <source>Roughing</source>
        <translation>Obróbka zgrubna</translation>
    </message>
    <message>
        <source>Its cutting data.</source>
        <translation>Jego parametry skrawania.</translation>
    </message>
    <message>
        <source>Finishing</source>
        <translation>Wykańczanie</translation>
    </message>
    <message>
        <source>Up to z</source>
        <translation>Do z</translation>
    </message>
    <message>
        <source>Where the section ends.</source>
        <translation>Gdzie kończy się odcinek.</translation>
    </message>
    <message>
        <source>Of the finish.</source>
        <translation>Wykończenia.</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Tytuł</translation>
    </message>
    <message>
        <source>Of the program.</source>
        <translation>Programu.</translation>
    </message>
    <message>
        <source>The bar.</source>
        <translation>Pręt.</translation>
    </message>
    <message>
        <source>How the work is held.</source>
        <translation>Sposób mocowania przedmiotu.</translation>
    </message>
    <message>
        <source>Inserts, blades and drills, by number.</source>
        <translation>Płytki, przecinaki i wiertła, według numerów.</translation>
    </message>
    <message>
        <source>Cutting data</source>
        <translation>Parametry skrawania</translation>
    </message>
    <message>
        <source>Depths, feeds and speeds.</source>
        <translation>Głębokości, posuwy i prędkości.</translation>
    </message>
    <message>
        <source>Of the spindle; empty: not limited.</source>
        <translation>Wrzeciona; puste: bez ograniczenia.</translation>
    </message>
    <message>
        <source>Speeds of the finish by section.</source>
        <translation>Prędkości wykańczania według odcinków.</translation>
    </message>
    <message>
        <source>Part off</source>
        <translation>Odcięcie</translation>
    </message>
    <message>
        <source>Cut the part off at its end.</source>
        <translation>Odetnij część na jej końcu.</translation>
    </message>
    <message>
        <source>Break of edges</source>
        <translation>Załamanie krawędzi</translation>
    </message>
    <message>
        <source>Chamfer of sharp edges; 0: sharp.</source>
        <translation>Faza ostrych krawędzi; 0: ostre.</translation>
    </message>
    <message>
        <source>an object with stock, setup, tools and cutting</source>
        <translation>obiekt z polami stock, setup, tools i cutting</translation>
    </message>
    <message>
        <source>the bar</source>
        <translation>pręt</translation>
    </message>
    <message>
        <source>how the work is held</source>
        <translation>sposób mocowania przedmiotu</translation>
    </message>
    <message>
        <source>a list of tools</source>
        <translation>lista narzędzi</translation>
    </message>
    <message>
        <source>the cutting data</source>
        <translation>parametry skrawania</translation>
    </message>
    <message>
        <source>the data of roughing</source>
        <translation>dane obróbki zgrubnej</translation>
    </message>
    <message>
        <source>the data of finishing</source>
        <translation>dane obróbki wykańczającej</translation>
    </message>
    <message>
        <source>Turning jobs</source>
        <translation>Zadania tokarskie</translation>
    </message>
    <message>
        <source>the radius of the arc</source>
        <translation>promień łuku</translation>
    </message>
    <message>
        <source>an arc that does not turn back along the axis</source>
        <translation>łuk, który nie zawraca wzdłuż osi</translation>
    </message>
    <message>
        <source>the diameter at its start</source>
        <translation>średnica na jego początku</translation>
    </message>
    <message>
        <source>the diameter at its end</source>
        <translation>średnica na jego końcu</translation>
    </message>
    <message>
        <source>width</source>
        <translation>szerokość</translation>
    </message>
    <message>
        <source>tip angle</source>
        <translation>kąt naroża</translation>
    </message>
    <message>
        <source>centre drill</source>
        <translation>nawiertak</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>obróbka zgrubna</translation>
    </message>
    <message>
        <source>semi-finish</source>
        <translation>obróbka półwykańczająca</translation>
    </message>
    <message>
        <source>finish</source>
        <translation>wykańczanie</translation>
    </message>
    <message>
        <source>finish, opposite hand</source>
        <translation>wykańczanie nożem przeciwnym</translation>
    </message>
    <message>
        <source>part off</source>
        <translation>odcięcie</translation>
    </message>
    <message>
        <source>Planning</source>
        <translation>Planowanie obróbki</translation>
    </message>
    <message>
        <source>Checking the program</source>
        <translation>Sprawdzanie programu</translation>
    </message>
    <message>
        <source>no finished cylinder is long enough to grip the part by</source>
        <translation>żaden wykończony walec nie jest dość długi, aby za niego zamocować część</translation>
    </message>
    <message>
        <source>The part cannot be clamped so: {reason}; {missing_mm} mm are missing.</source>
        <translation>Części nie można tak zamocować: {reason}; brakuje {missing_mm} mm.</translation>
    </message>
    <message>
        <source>There is no post “{found}”; expected a file or one of: {expected}.</source>
        <translation>Nie ma postprocesora „{found}”; oczekiwano pliku lub jednego z: {expected}.</translation>
    </message>
    <message>
        <source>The post {post} cannot {what}.</source>
        <translation>Postprocesor {post} nie może: {what}.</translation>
    </message>
    <message>
        <source>Tool {tool}: a feed of {feed_mm_rev} mm per revolution is more than its nose of {nose_radius_mm} mm allows; expected at most {most_mm_rev}.</source>
        <translation>Narzędzie {tool}: posuw {feed_mm_rev} mm na obrót jest większy, niż pozwala jego promień naroża {nose_radius_mm} mm; oczekiwano najwyżej {most_mm_rev}.</translation>
    </message>
    <message>
        <source>The material “{found}” is not in the library; expected one of: {expected}.</source>
        <translation>Materiału „{found}” nie ma w bibliotece; oczekiwano jednego z: {expected}.</translation>
    </message>
    <message>
        <source>The job states no highest speed of the spindle; {max_rpm} 1/min is written as the limit.</source>
        <translation>Zadanie nie podaje najwyższej prędkości obrotowej wrzeciona; jako granicę zapisano {max_rpm} obr/min.</translation>
    </message>
    <message>
        <source>Tool {tool} could reach the rest at z = {z_start_mm} … {z_end_mm} mm, but {reason}.</source>
        <translation>Narzędzie {tool} mogłoby sięgnąć naddatku pozostałego przy z = {z_start_mm} … {z_end_mm} mm, ale {reason}.</translation>
    </message>
    <message>
        <source>Assumed, from {source}: specific cutting force {k_c11_N_mm2} N/mm², exponent {m_c}.</source>
        <translation>Przyjęto, źródło: {source}: opór właściwy skrawania {k_c11_N_mm2} N/mm², wykładnik {m_c}.</translation>
    </message>
    <message>
        <source>The job states no material from the library, so no power is computed.</source>
        <translation>Zadanie nie podaje materiału z biblioteki, więc moc nie jest obliczana.</translation>
    </message>
    <message>
        <source>No stable speed for z = {z_start_mm} … {z_end_mm} mm; {speed_rpm} 1/min is kept.</source>
        <translation>Brak stabilnej prędkości obrotowej dla z = {z_start_mm} … {z_end_mm} mm; pozostaje {speed_rpm} obr/min.</translation>
    </message>
    <message>
        <source>Second clamping: gripped at z = {grip_start_mm} … {grip_end_mm} mm, chuck face {chuck_face_z_mm} mm from the new free end; {face_allowance_mm} mm are faced off there.</source>
        <translation>Drugie zamocowanie: chwyt na z = {grip_start_mm} … {grip_end_mm} mm, czoło uchwytu {chuck_face_z_mm} mm od nowego wolnego końca; planuje się tam {face_allowance_mm} mm.</translation>
    </message>
    <message>
        <source>The cylinder that is gripped in the second clamping carries a tolerance: use soft jaws.</source>
        <translation>Walec chwytany w drugim zamocowaniu ma tolerancję: użyj miękkich szczęk.</translation>
    </message>
    <message>
        <source>Two clampings were tried: they leave {left_mm} mm, one leaves {left_one_mm} mm.</source>
        <translation>Wypróbowano dwa zamocowania: zostawiają {left_mm} mm, jedno zostawia {left_one_mm} mm.</translation>
    </message>
    <message>
        <source>The finishing tool {tool} reaches where roughing does not and cuts up to {depth_mm} mm there, near z = {z_mm} mm.</source>
        <translation>Narzędzie wykańczające {tool} sięga tam, gdzie obróbka zgrubna nie sięga, i skrawa tam do {depth_mm} mm, w pobliżu z = {z_mm} mm.</translation>
    </message>
    <message>
        <source>no stable speed, that of the job is kept</source>
        <translation>brak stabilnej prędkości obrotowej, pozostaje prędkość z zadania</translation>
    </message>
    <message>
        <source>two where one leaves more</source>
        <translation>dwa, gdy jedno zostawia więcej</translation>
    </message>
    <message>
        <source>one</source>
        <translation>jeden</translation>
    </message>
    <message>
        <source>two</source>
        <translation>dwa</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>dokładnie</translation>
    </message>
    <message>
        <source>the finished part</source>
        <translation>gotowa część</translation>
    </message>
    <message>
        <source>the work at that moment</source>
        <translation>stan przedmiotu w tej chwili</translation>
    </message>
    <message>
        <source>Clampings</source>
        <translation>Zamocowania</translation>
    </message>
    <message>
        <source>Auto turns the part round where that leaves less on the drawing.</source>
        <translation>Automatycznie: odwraca część, jeśli wtedy mniej pozostaje względem rysunku.</translation>
    </message>
    <message>
        <source>Relation</source>
        <translation>Zależność</translation>
    </message>
    <message>
        <source>Between lobes and speeds.</source>
        <translation>Między krzywymi workowymi a prędkościami obrotowymi.</translation>
    </message>
    <message>
        <source>Part for the speeds</source>
        <translation>Część do doboru prędkości</translation>
    </message>
    <message>
        <source>Body whose dynamics decide the speeds of the finish.</source>
        <translation>Bryła, której dynamika decyduje o prędkościach obrotowych wykończenia.</translation>
    </message>
    <message>
        <source>Tool change</source>
        <translation>Wymiana narzędzia</translation>
    </message>
    <message>
        <source>Time of a tool change.</source>
        <translation>Czas wymiany narzędzia.</translation>
    </message>
    <message>
        <source>Left out</source>
        <translation>Pominięto</translation>
    </message>
    <message>
        <source>Operations that are switched off: clamping, kind, tool.</source>
        <translation>Operacje wyłączone: zamocowanie, rodzaj, narzędzie.</translation>
    </message>
    <message>
        <source>Operation</source>
        <translation>Operacja</translation>
    </message>
    <message>
        <source>First line</source>
        <translation>Pierwszy wiersz</translation>
    </message>
    <message>
        <source>Feed length</source>
        <translation>Droga robocza</translation>
    </message>
    <message>
        <source>cm³</source>
        <translation>cm³</translation>
    </message>
    <message>
        <source>Power at the cut, ± 25 %</source>
        <translation>Moc skrawania, ± 25 %</translation>
    </message>
    <message>
        <source>the face of the other end, finished</source>
        <translation>czoło drugiego końca, wykończone</translation>
    </message>
    <message>
        <source>the face of the free end, finished</source>
        <translation>czoło wolnego końca, wykończone</translation>
    </message>
    <message>
        <source>Chuck face</source>
        <translation>Czoło uchwytu</translation>
    </message>
    <message>
        <source>Time with tool changes</source>
        <translation>Czas z wymianami narzędzi</translation>
    </message>
    <message>
        <source>Frequency f_m</source>
        <translation>Częstotliwość f_m</translation>
    </message>
    <message>
        <source>Ideal Rz</source>
        <translation>Teoretyczne Rz</translation>
    </message>
    <message>
        <source>✗ the program is refused</source>
        <translation>✗ program odrzucony</translation>
    </message>
    <message>
        <source>{setups} clamping(s) · {time_min:1} min · gouge {gouge_um:2} µm · findings: {findings} · places with material left: {rest}</source>
        <translation>Zamocowania: {setups} · {time_min:1} min · wcięcie w zarys {gouge_um:2} µm · wykryte błędy: {findings} · miejsca z pozostałym materiałem: {rest}</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operacje</translation>
    </message>
    <message>
        <source>Speeds of the finish</source>
        <translation>Prędkości wykończenia</translation>
    </message>
    <message>
        <source>Turning program</source>
        <translation>Program tokarski</translation>
    </message>
    <message>
        <source>First clamping</source>
        <translation>Pierwsze zamocowanie</translation>
    </message>
    <message>
        <source>Second clamping</source>
        <translation>Drugie zamocowanie</translation>
    </message>
    <message>
        <source>Set-up sheet</source>
        <translation>Karta ustawcza</translation>
    </message>
    <message>
        <source>a list of texts</source>
        <translation>lista tekstów</translation>
    </message>
    <message>
        <source>a text of at most 200 characters</source>
        <translation>tekst o długości najwyżej 200 znaków</translation>
    </message>
    <message>
        <source>printable ASCII characters</source>
        <translation>drukowalne znaki ASCII</translation>
    </message>
    <message>
        <source>braces around title, number, tool, tool2, max_rpm, vc or rpm</source>
        <translation>nawiasy klamrowe wokół title, number, tool, tool2, max_rpm, vc lub rpm</translation>
    </message>
    <message>
        <source>a word such as G1</source>
        <translation>słowo takie jak G1</translation>
    </message>
    <message>
        <source>ik, r or cr</source>
        <translation>ik, r lub cr</translation>
    </message>
    <message>
        <source>an object with X, Z, F and style</source>
        <translation>obiekt z X, Z, F i style</translation>
    </message>
    <message>
        <source>per_rev or per_min</source>
        <translation>per_rev lub per_min</translation>
    </message>
    <message>
        <source>an object with open and close</source>
        <translation>obiekt z open i close</translation>
    </message>
    <message>
        <source>lf or crlf</source>
        <translation>lf lub crlf</translation>
    </message>
    <message>
        <source>lines, or css false</source>
        <translation>lines albo css false</translation>
    </message>
    <message>
        <source>the number</source>
        <translation>liczba</translation>
    </message>
    <message>
        <source>a number of decimals</source>
        <translation>liczba miejsc po przecinku</translation>
    </message>
    <message>
        <source>an object with diameter and decimals</source>
        <translation>obiekt z diameter i decimals</translation>
    </message>
    <message>
        <source>an object with decimals</source>
        <translation>obiekt z decimals</translation>
    </message>
    <message>
        <source>point or plain</source>
        <translation>point albo plain</translation>
    </message>
    <message>
        <source>how a comment begins</source>
        <translation>jak zaczyna się komentarz</translation>
    </message>
    <message>
        <source>state a feed per minute without a fixed speed</source>
        <translation>podają posuw minutowy bez stałej prędkości obrotowej</translation>
    </message>
    <message>
        <source>stated by the job</source>
        <translation>podane w zadaniu</translation>
    </message>
    <message>
        <source>constant cutting speed of the job</source>
        <translation>stała prędkość skrawania zadania</translation>
    </message>
    <message>
        <source>stability lobes</source>
        <translation>krzywe workowe stabilności</translation>
    </message>
    <message>
        <source>the blade does not reach so deep</source>
        <translation>przecinak nie sięga tak głęboko</translation>
    </message>
    <message>
        <source>it would meet the chuck</source>
        <translation>zderzyłoby się z uchwytem</translation>
    </message>
    <message>
        <source>it would meet the tailstock</source>
        <translation>zderzyłoby się z konikiem</translation>
    </message>
    <message>
        <source>its holder would meet the stock</source>
        <translation>jego oprawka uderzyłaby w półfabrykat</translation>
    </message>
    <message>
        <source>it would meet the stock on its way there</source>
        <translation>po drodze tam natrafiłoby na półfabrykat</translation>
    </message>
    <message>
        <source>the blade that parts off stands within the chuck</source>
        <translation>przecinak odcinający część znajduje się w obrębie uchwytu</translation>
    </message>
    <message>
        <source>First or second.</source>
        <translation>Pierwsze lub drugie.</translation>
    </message>
    <message>
        <source>What for.</source>
        <translation>Do czego.</translation>
    </message>
    <message>
        <source>the chuck stands within the length that is turned</source>
        <translation>uchwyt znajduje się w obrębie toczonej długości</translation>
    </message>
    <message>
        <source>the bar is held too short</source>
        <translation>pręt jest zamocowany na zbyt krótkim odcinku</translation>
    </message>
    <message>
        <source>Not given: {what}.</source>
        <translation>Nie podano: {what}.</translation>
    </message>
    <message>
        <source>The drawing has the sizes of the worn part as they were measured. Suggested nominal sizes are in {file}: take them with --snap apply, or state a drawing.</source>
        <translation>Rysunek zawiera zmierzone wymiary zużytej części. Proponowane wymiary nominalne są w {file}: przyjmij je opcją --snap apply albo podaj rysunek.</translation>
    </message>
    <message>
        <source>The program cannot be corrected for deflection: {reason}</source>
        <translation>Nie można skorygować programu ze względu na ugięcie: {reason}</translation>
    </message>
    <message>
        <source>The copy&apos;s diameters disagree with the prediction by more than both uncertainties: largest normalized error {normalized_error}.</source>
        <translation>Średnice kopii różnią się od przewidywań o więcej niż obie niepewności: największy błąd znormalizowany {normalized_error}.</translation>
    </message>
    <message>
        <source>done</source>
        <translation>gotowe</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>niepowodzenie</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nie osiągnięto</translation>
    </message>
    <message>
        <source>the schema of a dossier</source>
        <translation>schemat dokumentacji</translation>
    </message>
    <message>
        <source>Dossiers of copied parts</source>
        <translation>Dokumentacje skopiowanych części</translation>
    </message>
    <message>
        <source>Recognise the scan</source>
        <translation>Rozpoznaj skan</translation>
    </message>
    <message>
        <source>Drawing and CAD</source>
        <translation>Rysunek i CAD</translation>
    </message>
    <message>
        <source>Stable depths and speeds</source>
        <translation>Stabilne głębokości i prędkości</translation>
    </message>
    <message>
        <source>Check of the corrected program</source>
        <translation>Kontrola skorygowanego programu</translation>
    </message>
    <message>
        <source>Comparison of the copy</source>
        <translation>Porównanie kopii</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Kroki</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stan</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Wykonano</translation>
    </message>
    <message>
        <source>Files of the chain</source>
        <translation>Pliki łańcucha</translation>
    </message>
    <message>
        <source>Taken or made</source>
        <translation>Pobrano lub wykonano</translation>
    </message>
    <message>
        <source>SHA-256, first digits</source>
        <translation>SHA-256, pierwsze cyfry</translation>
    </message>
    <message>
        <source>taken</source>
        <translation>wykonano</translation>
    </message>
    <message>
        <source>made</source>
        <translation>wykonano</translation>
    </message>
    <message>
        <source>Numbers and where they stand</source>
        <translation>Liczby i ich położenie</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>Miejsce</translation>
    </message>
    <message>
        <source>Place of U</source>
        <translation>Położenie U</translation>
    </message>
    <message>
        <source>Copy of a part</source>
        <translation>Kopia części</translation>
    </message>
    <message>
        <source>{done} of {steps} steps done, {missing} missing, {failed} failed.</source>
        <translation>Wykonane kroki: {done} z {steps}, brakujące: {missing}, nieudane: {failed}.</translation>
    </message>
    <message>
        <source>{step}: {error}</source>
        <translation>{step}: {error}</translation>
    </message>
    <message>
        <source>Dossier of a copied part</source>
        <translation>Dokumentacja skopiowanej części</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <source>Where every number stands</source>
        <translation>Gdzie znajduje się każda liczba</translation>
    </message>
    <message>
        <source>Predicted and measured error of the diameter</source>
        <translation>Przewidywany i zmierzony błąd średnicy</translation>
    </message>
    <message>
        <source>95 % of samples</source>
        <translation>95 % próbek</translation>
    </message>
    <message>
        <source>measured, ± U</source>
        <translation>zmierzone, ± U</translation>
    </message>
    <message>
        <source>Tie</source>
        <translation>Powiązanie</translation>
    </message>
    <message>
        <source>Cylinders with the same one share a diameter.</source>
        <translation>Walce z tym samym powiązaniem mają wspólną średnicę.</translation>
    </message>
    <message>
        <source>place of the cut</source>
        <translation>miejsce podziału</translation>
    </message>
    <message>
        <source>a place inside the row</source>
        <translation>miejsce wewnątrz wiersza</translation>
    </message>
    <message>
        <source>more than 0° and less than 90°</source>
        <translation>więcej niż 0° i mniej niż 90°</translation>
    </message>
    <message>
        <source>that of a cylinder</source>
        <translation>średnicy walca</translation>
    </message>
    <message>
        <source>Line {line}: a cut along x alone down to the axis leaves no diameter; it is neither predicted nor corrected.</source>
        <translation>Wiersz {line}: przejście wyłącznie wzdłuż x aż do osi nie pozostawia średnicy; nie jest ani przewidywane, ani korygowane.</translation>
    </message>
    <message>
        <source>{cut_points} of {points} points were taken for something else than the part and cut off: turntable {turntable_points}, clamps {clamp_points}, loose things {clutter_points}.</source>
        <translation>{cut_points} z {points} punktów uznano za coś innego niż część i odcięto: stół obrotowy {turntable_points}, zaciski {clamp_points}, luźne przedmioty {clutter_points}.</translation>
    </message>
    <message>
        <source>The {end} stands on the plane that was cut off: it was put onto that plane, {moved_mm} mm beyond the data.</source>
        <translation>{end}: leży na płaszczyźnie odcięcia; przesunięto na tę płaszczyznę, {moved_mm} mm poza dane.</translation>
    </message>
    <message>
        <source>The facets of the mesh lie up to {sagitta_mm} mm inside the round surface: their corners were taken for it, and what lies between was put onto it.</source>
        <translation>Ścianki siatki leżą do {sagitta_mm} mm wewnątrz powierzchni obrotowej: przyjęto za nią ich naroża, a to, co leży między nimi, na nią przeniesiono.</translation>
    </message>
    <message>
        <source>there is no row beside it that could take its place</source>
        <translation>nie ma obok wiersza, który mógłby zająć jego miejsce</translation>
    </message>
    <message>
        <source>there is no row after it</source>
        <translation>nie ma po nim wiersza</translation>
    </message>
    <message>
        <source>a thread or a knurl stays a row of its own</source>
        <translation>gwint albo radełkowanie pozostaje osobnym wierszem</translation>
    </message>
    <message>
        <source>the place of the cut does not lie inside it</source>
        <translation>miejsce podziału nie leży wewnątrz niego</translation>
    </message>
    <message>
        <source>Surroundings</source>
        <translation>Otoczenie</translation>
    </message>
    <message>
        <source>keep all</source>
        <translation>zachowaj wszystko</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>odcięte</translation>
    </message>
    <message>
        <source>Besides the part</source>
        <translation>Obok części</translation>
    </message>
    <message>
        <source>There is no row {row} to be changed: {rows} rows were recognised.</source>
        <translation>Nie ma wiersza {row} do zmiany: rozpoznano wierszy: {rows}.</translation>
    </message>
    <message>
        <source>Row {row} cannot be changed like that: {reason}.</source>
        <translation>Wiersza {row} nie można tak zmienić: {reason}.</translation>
    </message>
    <message>
        <source>With these changes no contour fits the data: at z {z_mm} mm two rows do not meet.</source>
        <translation>Po tych zmianach żaden zarys nie pasuje do danych: przy z {z_mm} mm dwa wiersze się nie spotykają.</translation>
    </message>
    <message>
        <source>The rows were changed by hand ({count} times) and fitted again.</source>
        <translation>Wiersze zmieniono ręcznie (liczba zmian: {count}) i dopasowano na nowo.</translation>
    </message>
    <message>
        <source>A picture of {width} × {height} px is too large: {found} {unit}; at most {maximum} are read.</source>
        <translation>Obraz {width} × {height} px jest za duży: {found} {unit}; odczytuje się najwyżej {maximum}.</translation>
    </message>
    <message>
        <source>The picture has no pixels: {width} × {height}.</source>
        <translation>Obraz nie ma pikseli: {width} × {height}.</translation>
    </message>
    <message>
        <source>{found_bytes} bytes cannot hold a picture of {width} × {height} px; at least {expected_bytes} are expected.</source>
        <translation>{found_bytes} bajtów nie może zawierać obrazu {width} × {height} px; oczekiwano co najmniej {expected_bytes}.</translation>
    </message>
    <message>
        <source>Pictures of this kind are not read: found {found}, expected {expected}.</source>
        <translation>Obrazów tego rodzaju program nie odczytuje: znaleziono {found}, oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>The picture is damaged at row {row}: {reason}.</source>
        <translation>Zdjęcie jest uszkodzone w wierszu {row}: {reason}.</translation>
    </message>
    <message>
        <source>The picture ends early: {row} of {expected} rows are there.</source>
        <translation>Obraz kończy się za wcześnie: jest {row} z {expected} wierszy.</translation>
    </message>
    <message>
        <source>{path}: the picture was turned or mirrored as its EXIF orientation {orientation} says.</source>
        <translation>{path}: obraz obrócono lub odbito zgodnie z jego orientacją EXIF {orientation}.</translation>
    </message>
    <message>
        <source>{path}: the colour profile of the picture is not used.</source>
        <translation>{path}: profil kolorów obrazu nie jest używany.</translation>
    </message>
    <message>
        <source>{path}: the transparency of the picture is not used.</source>
        <translation>{path}: przezroczystość obrazu nie jest używana.</translation>
    </message>
    <message>
        <source>{path}: only the first of {count} pictures in the file was read.</source>
        <translation>{path}: odczytano tylko pierwszy z obrazów w pliku (liczba obrazów: {count}).</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Zdjęcia</translation>
    </message>
    <message>
        <source>a JPEG picture in grey or colour of 8 bits</source>
        <translation>obraz JPEG w szarości lub kolorze, 8 bitów</translation>
    </message>
    <message>
        <source>another number of bits than 8</source>
        <translation>liczba bitów inna niż 8</translation>
    </message>
    <message>
        <source>lossless, hierarchical or arithmetic coding</source>
        <translation>kodowanie bezstratne, hierarchiczne lub arytmetyczne</translation>
    </message>
    <message>
        <source>CMYK</source>
        <translation>CMYK</translation>
    </message>
    <message>
        <source>a number of components that is neither 1 nor 3</source>
        <translation>liczba składowych inna niż 1 lub 3</translation>
    </message>
    <message>
        <source>a JPEG marker before the first scan</source>
        <translation>znacznik JPEG przed pierwszym skanem</translation>
    </message>
    <message>
        <source>several frames</source>
        <translation>kilka klatek</translation>
    </message>
    <message>
        <source>an IHDR chunk of 13 bytes</source>
        <translation>blok IHDR o długości 13 bajtów</translation>
    </message>
    <message>
        <source>another chunk</source>
        <translation>inny blok danych</translation>
    </message>
    <message>
        <source>an IHDR chunk</source>
        <translation>blok IHDR</translation>
    </message>
    <message>
        <source>a TIFF directory of 1 to 1000 entries</source>
        <translation>katalog TIFF o 1 do 1000 wpisach</translation>
    </message>
    <message>
        <source>a TIFF directory</source>
        <translation>katalog TIFF</translation>
    </message>
    <message>
        <source>a TIFF picture in grey or RGB of 8 or 16 bits, not compressed or by LZW or deflate</source>
        <translation>obraz TIFF w szarości lub RGB, 8 lub 16 bitów, bez kompresji albo z kompresją LZW lub deflate</translation>
    </message>
    <message>
        <source>floating point samples</source>
        <translation>próbki zmiennoprzecinkowe</translation>
    </message>
    <message>
        <source>signed or complex samples</source>
        <translation>próbki ze znakiem lub zespolone</translation>
    </message>
    <message>
        <source>another number of bits than 8 or 16</source>
        <translation>liczba bitów inna niż 8 lub 16</translation>
    </message>
    <message>
        <source>a colour space that is neither grey nor RGB</source>
        <translation>przestrzeń barw, która nie jest ani szarością, ani RGB</translation>
    </message>
    <message>
        <source>more than four channels</source>
        <translation>więcej niż cztery kanały</translation>
    </message>
    <message>
        <source>RGB of fewer than three channels</source>
        <translation>RGB o mniej niż trzech kanałach</translation>
    </message>
    <message>
        <source>another compression</source>
        <translation>inna kompresja</translation>
    </message>
    <message>
        <source>strips or tiles far larger than the picture</source>
        <translation>paski lub kafelki znacznie większe niż obraz</translation>
    </message>
    <message>
        <source>strips or tiles of up to 400 MB</source>
        <translation>paski lub kafelki do 400 MB</translation>
    </message>
    <message>
        <source>a longer list</source>
        <translation>dłuższa lista</translation>
    </message>
    <message>
        <source>one for all pictures, or one for each</source>
        <translation>jedna dla wszystkich zdjęć albo po jednej dla każdego</translation>
    </message>
    <message>
        <source>auto, no, far, or the camera&apos;s distance from the axis in mm, beyond the surface</source>
        <translation>auto, no, far lub odległość kamery od osi w mm, ponad powierzchnią</translation>
    </message>
    <message>
        <source>one scale only</source>
        <translation>tylko jedna skala</translation>
    </message>
    <message>
        <source>a feed beside it</source>
        <translation>posuw obok niego</translation>
    </message>
    <message>
        <source>PX:MM, such as 250:1</source>
        <translation>PX:MM, np. 250:1</translation>
    </message>
    <message>
        <source>A picture of {width} × {height} px is too small: at least {minimum} px are needed either way.</source>
        <translation>Obraz {width} × {height} px jest za mały: w każdym kierunku potrzeba co najmniej {minimum} px.</translation>
    </message>
    <message>
        <source>A feed of {feed_mm_rev} mm is {found_px} px wide; at least {needed_px} px are needed, that is {needed_mm_per_px} mm/px or finer. Photograph closer.</source>
        <translation>Posuw {feed_mm_rev} mm ma szerokość {found_px} px; potrzeba co najmniej {needed_px} px, czyli {needed_mm_per_px} mm/px lub drobniej. Fotografuj z bliższej odległości.</translation>
    </message>
    <message>
        <source>A feed of {feed_mm_rev} mm is {found_px} px wide; at least {needed_px} px are needed. The marks of {alias_px} px in the picture are its alias. Photograph closer.</source>
        <translation>Posuw {feed_mm_rev} mm ma szerokość {found_px} px; potrzeba co najmniej {needed_px} px. Ślady {alias_px} px na obrazie są jego aliasem. Fotografuj z mniejszej odległości.</translation>
    </message>
    <message>
        <source>The region {found} does not lie in the picture of {width} × {height} px.</source>
        <translation>Obszar {found} nie leży w obrazie {width} × {height} px.</translation>
    </message>
    <message>
        <source>{path}: the marks are {pitch_mm} mm apart, the feed is {feed_mm_rev} mm. Scale or feed is wrong, or the marks are an alias.</source>
        <translation>{path}: ślady są oddalone o {pitch_mm} mm, posuw wynosi {feed_mm_rev} mm. Skala lub posuw są błędne albo ślady są aliasem.</translation>
    </message>
    <message>
        <source>The pictures are compared as if camera and light had been the same.</source>
        <translation>Obrazy są porównywane tak, jakby kamera i oświetlenie były takie same.</translation>
    </message>
    <message>
        <source>{path}: without the directions of feed and cut the sign of ν is open: {first_hz} or {second_hz} Hz. The usual, regenerative reading stands first.</source>
        <translation>{path}: bez kierunków posuwu i skrawania znak ν jest nieustalony: {first_hz} lub {second_hz} Hz. Zwykły odczyt, regeneracyjny, podano jako pierwszy.</translation>
    </message>
    <message>
        <source>{path}: only {waves} waves lie in the picture; the whole number of waves in a revolution is open. Photograph the whole width of the part, or choose among the candidates.</source>
        <translation>{path}: liczba fal na zdjęciu to tylko {waves}; całkowita liczba fal na obrót pozostaje nieustalona. Sfotografuj całą szerokość części albo wybierz spośród kandydatów.</translation>
    </message>
    <message>
        <source>{path}: {frequency_hz} Hz was chosen because {expected_hz} Hz was expected; the picture alone does not decide.</source>
        <translation>{path}: wybrano {frequency_hz} Hz, ponieważ oczekiwano {expected_hz} Hz; sam obraz tego nie rozstrzyga.</translation>
    </message>
    <message>
        <source>{path}: {percent} % of the pixels are black or white; the marks there are lost.</source>
        <translation>{path}: {percent} % pikseli jest czarnych lub białych; ślady są tam utracone.</translation>
    </message>
    <message>
        <source>{path}: a feed is {found_px} px wide; {wanted_px} px are better.</source>
        <translation>{path}: posuw ma szerokość {found_px} px; lepiej {wanted_px} px.</translation>
    </message>
    <message>
        <source>{path}: the scale was taken from the feed; the pitch is no check of it then.</source>
        <translation>{path}: skalę wyznaczono z posuwu; podziałka nie jest wtedy jej sprawdzeniem.</translation>
    </message>
    <message>
        <source>{path}: no scale is given; lengths are in pixels only.</source>
        <translation>{path}: nie podano skali; długości są tylko w pikselach.</translation>
    </message>
    <message>
        <source>{path}: the cylinder was unrolled over {span_deg}°.</source>
        <translation>{path}: walec rozwinięto na {span_deg}°.</translation>
    </message>
    <message>
        <source>The pictures show different surfaces (response {response}); they are aligned by scale and direction only.</source>
        <translation>Obrazy przedstawiają różne powierzchnie (odpowiedź {response}); dopasowano je tylko skalą i kierunkiem.</translation>
    </message>
    <message>
        <source>Left edge of the region.</source>
        <translation>Lewa krawędź obszaru.</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Góra</translation>
    </message>
    <message>
        <source>Upper edge of the region.</source>
        <translation>Górna krawędź obszaru.</translation>
    </message>
    <message>
        <source>Width of the region.</source>
        <translation>Szerokość obszaru.</translation>
    </message>
    <message>
        <source>Height of the region.</source>
        <translation>Wysokość obszaru.</translation>
    </message>
    <message>
        <source>Feed of the cut; none: the best comb of lines is taken for it.</source>
        <translation>Posuw skrawania; brak: przyjmuje się najlepszy grzebień linii.</translation>
    </message>
    <message>
        <source>Of the turned part.</source>
        <translation>Części toczonej.</translation>
    </message>
    <message>
        <source>Millimetres that a pixel is wide.</source>
        <translation>Szerokość piksela w milimetrach.</translation>
    </message>
    <message>
        <source>mm/px</source>
        <translation>mm/px</translation>
    </message>
    <message>
        <source>Scale bar</source>
        <translation>Pasek skali</translation>
    </message>
    <message>
        <source>Its length as PX:MM, such as 250:1.</source>
        <translation>Długość jako PX:MM, np. 250:1.</translation>
    </message>
    <message>
        <source>Scale from the feed</source>
        <translation>Skala z posuwu</translation>
    </message>
    <message>
        <source>The pitch of the marks is the feed, and checks nothing then.</source>
        <translation>Podziałka śladów jest wtedy posuwem i niczego nie sprawdza.</translation>
    </message>
    <message>
        <source>Unroll</source>
        <translation>Rozwiń</translation>
    </message>
    <message>
        <source>auto (a field wider than 0.2 diameters, seen from far), no, far, or the camera&apos;s distance from the axis in mm.</source>
        <translation>auto (pole szersze niż 0.2 średnicy, widziane z daleka), no, far lub odległość kamery od osi w mm.</translation>
    </message>
    <message>
        <source>Place of the axis</source>
        <translation>Położenie osi</translation>
    </message>
    <message>
        <source>Where the axis crosses the picture&apos;s middle, from the top (an upright axis: from the left); none: in the middle.</source>
        <translation>Gdzie oś przecina środek obrazu, od góry (oś pionowa: od lewej); brak: w środku.</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Obszar</translation>
    </message>
    <message>
        <source>Part of the picture that is evaluated: one for all pictures, or one for each.</source>
        <translation>Oceniany fragment zdjęcia: jeden dla wszystkich zdjęć albo po jednym dla każdego.</translation>
    </message>
    <message>
        <source>Direction of feed</source>
        <translation>Kierunek posuwu</translation>
    </message>
    <message>
        <source>In the picture, from right toward down; none: not known.</source>
        <translation>W obrazie, od kierunku w prawo ku dołowi; brak: nieznany.</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nieznane</translation>
    </message>
    <message>
        <source>down</source>
        <translation>w dół</translation>
    </message>
    <message>
        <source>up</source>
        <translation>w górę</translation>
    </message>
    <message>
        <source>Direction of cut</source>
        <translation>Kierunek skrawania</translation>
    </message>
    <message>
        <source>Along a track toward what was cut later, in a picture turned so that the feed points right.</source>
        <translation>Wzdłuż ścieżki w stronę tego, co skrawano później, na obrazie obróconym tak, że posuw wskazuje w prawo.</translation>
    </message>
    <message>
        <source>Expected frequency</source>
        <translation>Oczekiwana częstotliwość</translation>
    </message>
    <message>
        <source>Of a model or a tap test: chooses among the candidates that the picture leaves open.</source>
        <translation>Z modelu lub próby udarowej: wybiera spośród kandydatów, których obraz nie rozstrzyga.</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Fałszywe alarmy</translation>
    </message>
    <message>
        <source>Chance of a false line in a picture of noise.</source>
        <translation>Prawdopodobieństwo fałszywej linii w obrazie samego szumu.</translation>
    </message>
    <message>
        <source>Uncertainty of the speed</source>
        <translation>Niepewność prędkości</translation>
    </message>
    <message>
        <source>Standard uncertainty of the spindle speed.</source>
        <translation>Niepewność standardowa prędkości obrotowej.</translation>
    </message>
    <message>
        <source>Picture without its uneven light</source>
        <translation>Obraz bez nierównomiernego oświetlenia</translation>
    </message>
    <message>
        <source>marks found</source>
        <translation>znaleziono ślady</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>posuw</translation>
    </message>
    <message>
        <source>1/mm</source>
        <translation>1/mm</translation>
    </message>
    <message>
        <source>1/px</source>
        <translation>1/px</translation>
    </message>
    <message>
        <source>Frequency to the right</source>
        <translation>Częstotliwość w prawo</translation>
    </message>
    <message>
        <source>Frequency upward</source>
        <translation>Częstotliwość w górę</translation>
    </message>
    <message>
        <source>Decades over the surroundings</source>
        <translation>Dekady ponad otoczeniem</translation>
    </message>
    <message>
        <source>feed marks</source>
        <translation>ślady posuwu</translation>
    </message>
    <message>
        <source>chatter marks</source>
        <translation>ślady drgań</translation>
    </message>
    <message>
        <source>Pitch in the picture</source>
        <translation>Podziałka w obrazie</translation>
    </message>
    <message>
        <source>Pitch against the feed</source>
        <translation>Podziałka względem posuwu</translation>
    </message>
    <message>
        <source>Direction across the marks</source>
        <translation>Kierunek w poprzek śladów</translation>
    </message>
    <message>
        <source>Significance</source>
        <translation>Istotność</translation>
    </message>
    <message>
        <source>Regularity</source>
        <translation>Regularność</translation>
    </message>
    <message>
        <source>Share of the picture&apos;s variance</source>
        <translation>Udział w wariancji obrazu</translation>
    </message>
    <message>
        <source>Rest of a wave, ν</source>
        <translation>Reszta fali, ν</translation>
    </message>
    <message>
        <source>Whole waves in a revolution, m</source>
        <translation>Pełne fale na obrót, m</translation>
    </message>
    <message>
        <source>The picture decides m</source>
        <translation>Obraz rozstrzyga m</translation>
    </message>
    <message>
        <source>Phase of the regeneration, ε</source>
        <translation>Faza regeneracji, ε</translation>
    </message>
    <message>
        <source>Period along the axis</source>
        <translation>Okres wzdłuż osi</translation>
    </message>
    <message>
        <source>Pitch round the part</source>
        <translation>Podziałka na obwodzie części</translation>
    </message>
    <message>
        <source>Crests to the axis</source>
        <translation>Grzbiety względem osi</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandydaci</translation>
    </message>
    <message>
        <source>In symmetric light perhaps</source>
        <translation>W świetle symetrycznym możliwe</translation>
    </message>
    <message>
        <source>Distance of the next reading</source>
        <translation>Odległość do następnego odczytu</translation>
    </message>
    <message>
        <source>Strength against the feed line</source>
        <translation>Siła względem linii posuwu</translation>
    </message>
    <message>
        <source>m as measured</source>
        <translation>m zgodnie z pomiarem</translation>
    </message>
    <message>
        <source>Waves in the picture</source>
        <translation>Fale w obrazie</translation>
    </message>
    <message>
        <source>Lines seen</source>
        <translation>Widoczne linie</translation>
    </message>
    <message>
        <source>Bits of a sample</source>
        <translation>Bity na próbkę</translation>
    </message>
    <message>
        <source>Saturated pixels</source>
        <translation>Nasycone piksele</translation>
    </message>
    <message>
        <source>Cylinder unrolled</source>
        <translation>Walec rozwinięty</translation>
    </message>
    <message>
        <source>Threshold of significance</source>
        <translation>Próg istotności</translation>
    </message>
    <message>
        <source>Largest significance</source>
        <translation>Największa istotność</translation>
    </message>
    <message>
        <source>Chatter would be seen from</source>
        <translation>Drgania samowzbudne byłyby widoczne od</translation>
    </message>
    <message>
        <source>Scales are known</source>
        <translation>Skale są znane</translation>
    </message>
    <message>
        <source>Response of the registration</source>
        <translation>Odpowiedź dopasowania obrazów</translation>
    </message>
    <message>
        <source>One surface in both</source>
        <translation>Jedna powierzchnia w obu</translation>
    </message>
    <message>
        <source>Picture as evaluated</source>
        <translation>Zdjęcie w postaci ocenianej</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Obraz</translation>
    </message>
    <message>
        <source>Feed marks</source>
        <translation>Ślady posuwu</translation>
    </message>
    <message>
        <source>Chatter marks</source>
        <translation>Ślady drgań</translation>
    </message>
    <message>
        <source>Marks of the surface</source>
        <translation>Ślady na powierzchni</translation>
    </message>
    <message>
        <source>no periodic marks found</source>
        <translation>nie znaleziono śladów okresowych</translation>
    </message>
    <message>
        <source>The strongest line is {largest} times the noise; {threshold} would be a mark.</source>
        <translation>Najsilniejszy prążek to {largest}-krotność szumu; śladem byłaby {threshold}-krotność.</translation>
    </message>
    <message>
        <source>Feed marks {pitch} mm apart, no chatter marks above {limit} % of the feed line.</source>
        <translation>Ślady posuwu co {pitch} mm, brak śladów drgań powyżej {limit} % linii posuwu.</translation>
    </message>
    <message>
        <source>Feed marks {pitch} px apart, no chatter marks above {limit} % of the feed line.</source>
        <translation>Ślady posuwu w odstępie {pitch} px, brak śladów drgań powyżej {limit} % linii posuwu.</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Porównanie</translation>
    </message>
    <message>
        <source>Marks of turned surfaces</source>
        <translation>Ślady na powierzchniach toczonych</translation>
    </message>
    <message>
        <source>The picture is divided by its local mean and spread; lines of its spectrum count when their power exceeds the level of the noise along rows and columns by the threshold. The feed marks are the comb at 1/f, and give the direction of the axis; the chatter marks are a lattice of lines beside it, whose wave vector gives the frequency f_c = n (πD k_y + f k_z). Heights cannot be told from a picture.</source>
        <translation>Obraz dzieli się przez jego lokalną średnią i rozrzut; linie jego widma liczą się, gdy ich moc przekracza o próg poziom szumu wzdłuż wierszy i kolumn. Ślady posuwu tworzą grzebień przy 1/f i wyznaczają kierunek osi; ślady drgań to siatka linii obok niego, której wektor falowy daje częstotliwość f_c = n (πD k_y + f k_z). Wysokości nie da się odczytać z obrazu.</translation>
    </message>
    <message>
        <source>Of the tool in a revolution.</source>
        <translation>Narzędzia na obrót.</translation>
    </message>
    <message>
        <source>Of the tool.</source>
        <translation>Narzędzia.</translation>
    </message>
    <message>
        <source>While the surface was cut.</source>
        <translation>Podczas skrawania powierzchni.</translation>
    </message>
    <message>
        <source>Vibration</source>
        <translation>Drgania</translation>
    </message>
    <message>
        <source>Its frequency.</source>
        <translation>Częstotliwość.</translation>
    </message>
    <message>
        <source>Of the vibration; 0: none.</source>
        <translation>Drgań; 0: brak.</translation>
    </message>
    <message>
        <source>In the picture, from right toward down.</source>
        <translation>Na zdjęciu, od prawej ku dołowi.</translation>
    </message>
    <message>
        <source>Of the picture.</source>
        <translation>Obrazu.</translation>
    </message>
    <message>
        <source>Whole width</source>
        <translation>Cała szerokość</translation>
    </message>
    <message>
        <source>The part is seen as a cylinder.</source>
        <translation>Część jest widziana jako walec.</translation>
    </message>
    <message>
        <source>along the feed</source>
        <translation>wzdłuż posuwu</translation>
    </message>
    <message>
        <source>along the grooves</source>
        <translation>wzdłuż rowków</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>ukośny</translation>
    </message>
    <message>
        <source>all round</source>
        <translation>dookoła</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Światło</translation>
    </message>
    <message>
        <source>Where it comes from.</source>
        <translation>Skąd pochodzi.</translation>
    </message>
    <message>
        <source>Irregular tracks</source>
        <translation>Nieregularne ślady</translation>
    </message>
    <message>
        <source>Spread of their depths as a share of the depth of a feed mark.</source>
        <translation>Rozrzut ich głębokości jako część głębokości śladu posuwu.</translation>
    </message>
    <message>
        <source>Noise</source>
        <translation>Szum</translation>
    </message>
    <message>
        <source>Of the camera, as a share of full scale.</source>
        <translation>Kamery, jako część pełnego zakresu.</translation>
    </message>
    <message>
        <source>Start of the random numbers.</source>
        <translation>Wartość początkowa liczb losowych.</translation>
    </message>
    <message>
        <source>Drop two files here, first the original (scan or drawing), then the copy.</source>
        <translation>Upuść tu dwa pliki, najpierw oryginał (skan lub rysunek), potem kopię.</translation>
    </message>
    <message>
        <source>Same ⌀ as</source>
        <translation>Ta sama ⌀ co</translation>
    </message>
    <message>
        <source>Measured − nominal</source>
        <translation>Zmierzone − nominalne</translation>
    </message>
    <message>
        <source>from the free end</source>
        <translation>od wolnego końca</translation>
    </message>
    <message>
        <source>as a chain</source>
        <translation>łańcuchem</translation>
    </message>
    <message>
        <source>Lengths</source>
        <translation>Długości</translation>
    </message>
    <message>
        <source>How the drawing gives lengths, and what an edited one leaves in place: from the free end all other shoulders, as a chain all other lengths.</source>
        <translation>Jak rysunek podaje długości i co zostaje na miejscu po zmianie jednej z nich: od wolnego końca pozostałe odsadzenia, łańcuchem pozostałe długości.</translation>
    </message>
    <message>
        <source>{number}: {left_mm:3} mm, {cause}</source>
        <translation>{number}: {left_mm:3} mm, {cause}</translation>
    </message>
    <message>
        <source>Drawing, stock and tool, second clamping</source>
        <translation>Rysunek, półfabrykat i narzędzie, drugie zamocowanie</translation>
    </message>
    <message>
        <source>z from the raw end</source>
        <translation>z od surowego końca</translation>
    </message>
    <message>
        <source>material stays</source>
        <translation>materiał pozostaje</translation>
    </message>
    <message>
        <source>Why this speed: z {from:1}-{to:1} mm</source>
        <translation>Dlaczego ta prędkość: z {from:1}-{to:1} mm</translation>
    </message>
    <message>
        <source>Zero of the program</source>
        <translation>Punkt zerowy programu</translation>
    </message>
    <message>
        <source>Job</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Drop a job (JOB.json) and a shaft here: its turning program follows, read back and checked.</source>
        <translation>Upuść tu zadanie (JOB.json) i wałek: powstanie jego program toczenia, odczytany ponownie i sprawdzony.</translation>
    </message>
    <message>
        <source>Job changed from</source>
        <translation>Zadanie zmienione względem</translation>
    </message>
    <message>
        <source>The file that the form was changed from.</source>
        <translation>Plik, względem którego zmieniono formularz.</translation>
    </message>
    <message>
        <source>Job or tools</source>
        <translation>Zadanie lub narzędzia</translation>
    </message>
    <message>
        <source>Stock, set-up, tools and cutting data, from JOB.json.</source>
        <translation>Półfabrykat, ustawienie, narzędzia i parametry skrawania, z JOB.json.</translation>
    </message>
    <message>
        <source>The part, from FILE (SHAFT.json, STEP, CSV), instead of the one in the job.</source>
        <translation>Część z pliku FILE (SHAFT.json, STEP, CSV) zamiast tej z zadania.</translation>
    </message>
    <message>
        <source>What the program was corrected by: FILE that deflection --compensate wrote with --json.</source>
        <translation>Czym skorygowano program: FILE zapisany przez deflection --compensate z --json.</translation>
    </message>
    <message>
        <source>Program before</source>
        <translation>Program poprzedni</translation>
    </message>
    <message>
        <source>The program of the first clamping, for --setup 2.</source>
        <translation>Program pierwszego zamocowania, dla --setup 2.</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Folder</translation>
    </message>
    <message>
        <source>Where every file goes; made when it is missing.</source>
        <translation>Dokąd trafiają wszystkie pliki; tworzony, gdy go brak.</translation>
    </message>
    <message>
        <source>Set-up of deflection</source>
        <translation>Ustawienie ugięcia</translation>
    </message>
    <message>
        <source>The scan of the machined copy.</source>
        <translation>Skan obrobionej kopii.</translation>
    </message>
    <message>
        <source>SHAFT.json that somebody has confirmed, in place of what was recognised.</source>
        <translation>SHAFT.json zatwierdzony przez człowieka, zamiast wyniku rozpoznania.</translation>
    </message>
    <message>
        <source>Confirmed by</source>
        <translation>Potwierdził</translation>
    </message>
    <message>
        <source>Who answers for the drawing.</source>
        <translation>Kto odpowiada za rysunek.</translation>
    </message>
    <message>
        <source>Post</source>
        <translation>Postprocesor</translation>
    </message>
    <message>
        <source>Control that the program is for: fanuc_a, fanuc_b, haas, sinumerik, linuxcnc, grbl, or POST.json.</source>
        <translation>Sterowanie, dla którego jest program: fanuc_a, fanuc_b, haas, sinumerik, linuxcnc, grbl lub POST.json.</translation>
    </message>
    <message>
        <source>Tolerance of the copy</source>
        <translation>Tolerancja kopii</translation>
    </message>
    <message>
        <source>Of its surface, to both sides.</source>
        <translation>Jego powierzchni, w obie strony.</translation>
    </message>
    <message>
        <source>Tolerance of the predicted diameter</source>
        <translation>Tolerancja przewidywanej średnicy</translation>
    </message>
    <message>
        <source>To both sides.</source>
        <translation>Na obie strony.</translation>
    </message>
    <message>
        <source>Planning the program</source>
        <translation>Planowanie programu</translation>
    </message>
    <message>
        <source>a set-up of deflection (--setup)</source>
        <translation>ustawienie dla deflection (--setup)</translation>
    </message>
    <message>
        <source>a corrected program</source>
        <translation>poprawiony program</translation>
    </message>
    <message>
        <source>Checking the corrected program</source>
        <translation>Sprawdzanie poprawionego programu</translation>
    </message>
    <message>
        <source>the scan of the copy (--copy)</source>
        <translation>skan kopii (--copy)</translation>
    </message>
    <message>
        <source>Comparing the copy</source>
        <translation>Porównywanie kopii</translation>
    </message>
    <message>
        <source>Stock, set-up, tools and cutting data, from JOB.json; without it the operand is a job that holds its shaft.</source>
        <translation>Półfabrykat, ustawienie, narzędzia i parametry skrawania z JOB.json; bez tej opcji argumentem jest zadanie, które zawiera swój wałek.</translation>
    </message>
    <message>
        <source>Machine at the chuck face, from SPINDLE.json: speeds follow its dynamics.</source>
        <translation>Maszyna przy czole uchwytu, z SPINDLE.json: prędkości obrotowe wynikają z jej dynamiki.</translation>
    </message>
    <message>
        <source>Tool {tool}: “{found}” is not in the library; expected one of: {expected}.</source>
        <translation>Narzędzie {tool}: „{found}” nie ma w bibliotece; oczekiwano jednego z: {expected}.</translation>
    </message>
    <message>
        <source>threading</source>
        <translation>nacinanie gwintu</translation>
    </message>
    <message>
        <source>ISO code from the library, such as CNMG 120408.</source>
        <translation>Kod ISO z biblioteki, np. CNMG 120408.</translation>
    </message>
    <message>
        <source>Holder&apos;s code</source>
        <translation>Kod oprawki</translation>
    </message>
    <message>
        <source>ISO code from the library, such as PCLNL 2525M12.</source>
        <translation>Kod ISO z biblioteki, np. PCLNL 2525M12.</translation>
    </message>
    <message>
        <source>The drawing allows Rz {Rz_um} µm at z = {z_start_mm} … {z_end_mm} mm: the finish feeds {feed_mm_rev:3} mm per revolution there (ideal Rz {ideal_Rz_um:2} µm).</source>
        <translation>Rysunek dopuszcza Rz {Rz_um} µm dla z = {z_start_mm} … {z_end_mm} mm: posuw wykończenia wynosi tam {feed_mm_rev:3} mm na obrót (idealne Rz {ideal_Rz_um:2} µm).</translation>
    </message>
    <message>
        <source>The drawing allows Rz {Rz_um} µm at z = {z_start_mm} … {z_end_mm} mm; at the least feed of {feed_mm_rev:3} mm per revolution the ideal Rz of tool {tool} is {ideal_Rz_um:2} µm.</source>
        <translation>Rysunek dopuszcza Rz {Rz_um} µm dla z = {z_start_mm} … {z_end_mm} mm; przy najmniejszym posuwie {feed_mm_rev:3} mm na obrót idealne Rz narzędzia {tool} wynosi {ideal_Rz_um:2} µm.</translation>
    </message>
    <message>
        <source>The thread {designation} is not cut, {reason}: its body is turned to the drawn diameter.</source>
        <translation>Gwint {designation} nie jest nacinany, {reason}: jego trzon toczy się na średnicę z rysunku.</translation>
    </message>
    <message>
        <source>Thread {designation}: pitch {pitch_mm} mm, {passes} passes to a depth of {depth_mm:3} mm; what it takes off is not looked at.</source>
        <translation>Gwint {designation}: skok {pitch_mm} mm, przejścia: {passes}, do głębokości {depth_mm:3} mm; tego, co zbiera, się nie sprawdza.</translation>
    </message>
    <message>
        <source>Edges broken by {edge_break_mm} mm as the job asks: {count}; left sharp: {left}.</source>
        <translation>Krawędzie stępione o {edge_break_mm} mm zgodnie z zadaniem: {count}; pozostawione ostre: {left}.</translation>
    </message>
    <message>
        <source>Tool {tool}: {quantity} of {found} is outside {low} … {high}, the range of its insert ({standing}).</source>
        <translation>Narzędzie {tool}: {quantity} {found} jest poza zakresem {low} … {high} jego płytki ({standing}).</translation>
    </message>
    <message>
        <source>The part is not cut off: it stands between chuck and tailstock.</source>
        <translation>Część nie jest odcinana: stoi między uchwytem a konikiem.</translation>
    </message>
    <message>
        <source>The end is not faced: tool {tool} would meet the tailstock.</source>
        <translation>Czoło nie jest planowane: narzędzie {tool} trafiłoby w konik.</translation>
    </message>
    <message>
        <source>The speeds are those of a part whose end is free; the tailstock holds it stiffer.</source>
        <translation>Prędkości dotyczą części o wolnym końcu; konik trzyma ją sztywniej.</translation>
    </message>
    <message>
        <source>Stable up to a depth of</source>
        <translation>Stabilne do głębokości</translation>
    </message>
    <message>
        <source>F or K</source>
        <translation>F lub K</translation>
    </message>
    <message>
        <source>cut threads</source>
        <translation>nacinać gwintów</translation>
    </message>
    <message>
        <source>there is no tool for threads</source>
        <translation>bo nie ma narzędzia do gwintów</translation>
    </message>
    <message>
        <source>it is switched off</source>
        <translation>bo jest wyłączony</translation>
    </message>
    <message>
        <source>its tool would meet something</source>
        <translation>bo jego narzędzie w coś by trafiło</translation>
    </message>
    <message>
        <source>its pitch or its place is not understood</source>
        <translation>bo jego skok lub miejsce jest niezrozumiałe</translation>
    </message>
    <message>
        <source>it is left-handed or has several starts</source>
        <translation>bo jest lewy lub wielokrotny</translation>
    </message>
    <message>
        <source>its row is no cylinder that could carry it</source>
        <translation>bo jego wiersz nie jest walcem, który mógłby go unieść</translation>
    </message>
    <message>
        <source>what stands before it is higher</source>
        <translation>bo to, co stoi przed nim, jest wyższe</translation>
    </message>
    <message>
        <source>its row is too short</source>
        <translation>bo jego wiersz jest za krótki</translation>
    </message>
    <message>
        <source>Range for it.</source>
        <translation>Jej zakres.</translation>
    </message>
    <message>
        <source>Largest cutting speed</source>
        <translation>Największa prędkość skrawania</translation>
    </message>
    <message>
        <source>a feed</source>
        <translation>posuw</translation>
    </message>
    <message>
        <source>a cutting speed</source>
        <translation>prędkość skrawania</translation>
    </message>
    <message>
        <source>a depth</source>
        <translation>głębokość</translation>
    </message>
    <message>
        <source>Width of the tolerance</source>
        <translation>Szerokość pola tolerancji</translation>
    </message>
    <message>
        <source>the part is cut off last: nothing holds it afterwards</source>
        <translation>część odcina się na końcu: potem nic jej nie trzyma</translation>
    </message>
    <message>
        <source>the centre hole is drilled into the finished face</source>
        <translation>nakiełek wierci się w splanowanym czole</translation>
    </message>
    <message>
        <source>the other tools start from the finished face</source>
        <translation>pozostałe narzędzia zaczynają od splanowanego czoła</translation>
    </message>
    <message>
        <source>the tailstock has to hold the work before it is turned</source>
        <translation>konik musi podeprzeć przedmiot, zanim zacznie się toczenie</translation>
    </message>
    <message>
        <source>the finishing tool would have to take off what roughing takes</source>
        <translation>nóż wykańczający musiałby zdjąć to, co zdejmuje obróbka zgrubna</translation>
    </message>
    <message>
        <source>the stock around it is roughed first</source>
        <translation>najpierw zdejmuje się zgrubnie materiał wokół</translation>
    </message>
    <message>
        <source>the finish needs an even allowance, without the steps of roughing</source>
        <translation>wykańczanie wymaga równego naddatku, bez stopni po obróbce zgrubnej</translation>
    </message>
    <message>
        <source>“{operation}” cannot run before “{needed}”: {reason}.</source>
        <translation>„{operation}” nie może poprzedzać „{needed}”: {reason}.</translation>
    </message>
    <message>
        <source>The program of clamping {clamping} was changed after its check; check it again first.</source>
        <translation>Program zamocowania {clamping} zmieniono po kontroli; najpierw sprawdź go ponownie.</translation>
    </message>
    <message>
        <source>The program of clamping {clamping} is not the planned one: it was changed by hand.</source>
        <translation>Program zamocowania {clamping} nie jest zaplanowanym: zmieniono go ręcznie.</translation>
    </message>
    <message>
        <source>Clamping {clamping}: changes by hand belong to another program than the one that stands here now, and are left out.</source>
        <translation>Zamocowanie {clamping}: ręczne zmiany należą do innego programu niż obecny i zostały pominięte.</translation>
    </message>
    <message>
        <source>The program of clamping {clamping} is “{item}”, corrected for deflection by up to {correction_um} µm of the radius; it is checked against the drawing with this correction.</source>
        <translation>Programem zamocowania {clamping} jest „{item}”, skorygowany ze względu na ugięcie o nie więcej niż {correction_um} µm na promieniu; sprawdza się go względem rysunku z tą korekcją.</translation>
    </message>
    <message>
        <source>“{item}” was corrected from another program than the one that is planned now: correct that one again.</source>
        <translation>„{item}” powstał z korekcji innego programu niż zaplanowany teraz: skoryguj obecny ponownie.</translation>
    </message>
    <message>
        <source>The program of clamping {clamping} is {path}, and not the planned one.</source>
        <translation>Programem zamocowania {clamping} jest {path}, a nie zaplanowany.</translation>
    </message>
    <message>
        <source>Operations in the order in which they run: clamping, kind, tool. Those that are not named keep their places.</source>
        <translation>Operacje w kolejności wykonywania: zamocowanie, rodzaj, narzędzie. Niewymienione zostają na swoich miejscach.</translation>
    </message>
    <message>
        <source>the depth in mm</source>
        <translation>głębokość w mm</translation>
    </message>
    <message>
        <source>more than the rows before it are long</source>
        <translation>więcej niż długość wierszy przed nim</translation>
    </message>
    <message>
        <source>The stock is the bar that the program was planned for, {length_mm} mm up to the chuck.</source>
        <translation>Półfabrykatem jest pręt, dla którego zaplanowano program: {length_mm} mm do uchwytu.</translation>
    </message>
    <message>
        <source>From the mouth inward. A file fills the table; once it is changed, it rules.</source>
        <translation>Od wylotu w głąb. Plik wypełnia tabelę; po zmianie obowiązuje tabela.</translation>
    </message>
    <message>
        <source>Bores changed from</source>
        <translation>Otwory zmienione względem</translation>
    </message>
    <message>
        <source>The input that the table of bores was changed from.</source>
        <translation>Dane, względem których zmieniono tabelę otworów.</translation>
    </message>
    <message>
        <source>Drawing, stock and tool, first clamping</source>
        <translation>Rysunek, półfabrykat i narzędzie, pierwsze zamocowanie</translation>
    </message>
    <message>
        <source>finished up to here</source>
        <translation>wykończone dotąd</translation>
    </message>
    <message>
        <source>Speed N of the finish</source>
        <translation>Obroty N wykańczania</translation>
    </message>
    <message>
        <source>Cutting speed v_c of the finish</source>
        <translation>Prędkość skrawania v_c wykańczania</translation>
    </message>
    <message>
        <source>v_c</source>
        <translation>v_c</translation>
    </message>
    <message>
        <source>Frequency of chatter f_m</source>
        <translation>Częstotliwość drgań f_m</translation>
    </message>
    <message>
        <source>f_m</source>
        <translation>f_m</translation>
    </message>
    <message>
        <source>Ideal roughness Rz of the finish</source>
        <translation>Teoretyczna chropowatość Rz wykańczania</translation>
    </message>
    <message>
        <source>Rz</source>
        <translation>Rz</translation>
    </message>
    <message>
        <source>Roughness that the drawing allows.</source>
        <translation>Chropowatość dopuszczona przez rysunek.</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Gwint</translation>
    </message>
    <message>
        <source>Cut on this row, such as M16x1.5.</source>
        <translation>Nacinany na tym wierszu, np. M16x1.5.</translation>
    </message>
    <message>
        <source>? check void</source>
        <translation>? kontrola nieważna</translation>
    </message>
    <message>
        <source>A program was changed after its check: check it again.</source>
        <translation>Program zmieniono po kontroli: sprawdź go ponownie.</translation>
    </message>
    <message>
        <source>✓ compensated, checked</source>
        <translation>✓ skompensowany, sprawdzony</translation>
    </message>
    <message>
        <source>✗ compensated; material stays</source>
        <translation>✗ skompensowany; materiał pozostaje</translation>
    </message>
    <message>
        <source>Programs that were changed by hand and stand in place of planned ones.</source>
        <translation>Programy zmienione ręcznie, które stoją w miejscu zaplanowanych.</translation>
    </message>
    <message>
        <source>Changed from</source>
        <translation>Zmieniony z</translation>
    </message>
    <message>
        <source>SHA-256 of the program before.</source>
        <translation>SHA-256 programu przed zmianami.</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Sprawdzony</translation>
    </message>
    <message>
        <source>SHA-256 of the text that was checked.</source>
        <translation>SHA-256 sprawdzonego tekstu.</translation>
    </message>
    <message>
        <source>a thread is cut into its finished row</source>
        <translation>gwint nacina się w jego wykończonym wierszu</translation>
    </message>
    <message>
        <source>At {speed_rpm} 1/min depths up to {stable_depth_mm:3} mm would be stable at z = {z_start_mm} … {z_end_mm} mm, with the force of the work material.</source>
        <translation>Przy {speed_rpm} obr/min na z = {z_start_mm} … {z_end_mm} mm stabilne byłyby głębokości do {stable_depth_mm:3} mm, przy sile skrawania materiału przedmiotu.</translation>
    </message>
    <message>
        <source>{step}: {path} is no longer what it was when the chain was run.</source>
        <translation>{step}: plik {path} zmienił się od wykonania łańcucha.</translation>
    </message>
    <message>
        <source>Stiffness and forces cannot be fitted to the copy: {reason}</source>
        <translation>Sztywności i sił nie można dopasować do kopii: {reason}</translation>
    </message>
    <message>
        <source>Photograph before</source>
        <translation>Zdjęcie przed</translation>
    </message>
    <message>
        <source>Of the turned surface before the speeds were chosen anew.</source>
        <translation>Toczonej powierzchni, sprzed ponownego doboru prędkości.</translation>
    </message>
    <message>
        <source>Photograph after</source>
        <translation>Zdjęcie po</translation>
    </message>
    <message>
        <source>Of the same surface on the copy, taken alike.</source>
        <translation>Tej samej powierzchni na kopii, wykonane w tych samych warunkach.</translation>
    </message>
    <message>
        <source>Place of the photographs</source>
        <translation>Miejsce zdjęć</translation>
    </message>
    <message>
        <source>z from the free end: diameter and speed there turn marks into frequencies.</source>
        <translation>z od wolnego końca: z tamtejszej średnicy i prędkości ślady przelicza się na częstotliwości.</translation>
    </message>
    <message>
        <source>Scale of the photographs</source>
        <translation>Skala zdjęć</translation>
    </message>
    <message>
        <source>Width of a pixel.</source>
        <translation>Szerokość piksela.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Kontynuuj</translation>
    </message>
    <message>
        <source>Take over the steps in the folder whose files and questions are as they were.</source>
        <translation>Przejmij z folderu kroki, których pliki i pytania się nie zmieniły.</translation>
    </message>
    <message>
        <source>the scan of the worn part, or a drawing</source>
        <translation>skan zużytej części lub rysunek</translation>
    </message>
    <message>
        <source>a drawing</source>
        <translation>rysunek</translation>
    </message>
    <message>
        <source>the machine (--machine)</source>
        <translation>maszyna (--machine)</translation>
    </message>
    <message>
        <source>the job (--job)</source>
        <translation>zadanie (--job)</translation>
    </message>
    <message>
        <source>photographs before and after (--photograph-before, --photograph-after)</source>
        <translation>zdjęcia przed i po (--photograph-before, --photograph-after)</translation>
    </message>
    <message>
        <source>the scan of the worn part</source>
        <translation>skan zużytej części</translation>
    </message>
    <message>
        <source>a cylinder that the second clamping can grip</source>
        <translation>walec, za który można chwycić w drugim zamocowaniu</translation>
    </message>
    <message>
        <source>Proof</source>
        <translation>Weryfikacja</translation>
    </message>
    <message>
        <source>Photographs</source>
        <translation>Zdjęcia</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>nieaktualne</translation>
    </message>
    <message>
        <source>done, missing, failed or not_reached</source>
        <translation>done, missing, failed lub not_reached</translation>
    </message>
    <message>
        <source>Largest deviation of the copy</source>
        <translation>Największa odchyłka kopii</translation>
    </message>
    <message>
        <source>Taken over from an earlier run</source>
        <translation>Przejęte z wcześniejszego przebiegu</translation>
    </message>
    <message>
        <source>Deflection, second clamping</source>
        <translation>Ugięcie, drugie zamocowanie</translation>
    </message>
    <message>
        <source>Photographs of the surface</source>
        <translation>Zdjęcia powierzchni</translation>
    </message>
    <message>
        <source>copy along z, ± U</source>
        <translation>kopia wzdłuż z, ± U</translation>
    </message>
    <message>
        <source>From z [mm]</source>
        <translation>Od z [mm]</translation>
    </message>
    <message>
        <source>To z [mm]</source>
        <translation>Do z [mm]</translation>
    </message>
    <message>
        <source>Predicted [µm]</source>
        <translation>Przewidywany [µm]</translation>
    </message>
    <message>
        <source>U [µm]</source>
        <translation>U [µm]</translation>
    </message>
    <message>
        <source>Measured [µm]</source>
        <translation>Zmierzony [µm]</translation>
    </message>
    <message>
        <source>Agreement</source>
        <translation>Zgodność</translation>
    </message>
    <message>
        <source>✓ agrees</source>
        <translation>✓ zgodne</translation>
    </message>
    <message>
        <source>✗ disagrees</source>
        <translation>✗ niezgodne</translation>
    </message>
    <message>
        <source>Of the diameter, where its limits are not stated.</source>
        <translation>Średnicy, gdy nie podano jej wymiarów granicznych.</translation>
    </message>
    <message>
        <source>marks {frequency} Hz</source>
        <translation>ślady {frequency} Hz</translation>
    </message>
    <message>
        <source>Your marks say {marks} ± {uncertainty} Hz, your model says {model} Hz: {percent} % apart. Frequency response, diameter, speed or number of waves may be wrong.</source>
        <translation>Ślady wskazują {marks} ± {uncertainty} Hz, model {model} Hz: różnica {percent} %. Błędna może być charakterystyka częstotliwościowa, średnica, prędkość lub liczba fal.</translation>
    </message>
    <message>
        <source>Your marks say {marks} ± {uncertainty} Hz, your model says {model} Hz; the nearest other reading is {other} Hz away.</source>
        <translation>Ślady wskazują {marks} ± {uncertainty} Hz, model {model} Hz; najbliższy inny odczyt jest oddalony o {other} Hz.</translation>
    </message>
    <message>
        <source>Your marks say {marks} ± {uncertainty} Hz, your model says {model} Hz.</source>
        <translation>Ślady wskazują {marks} ± {uncertainty} Hz, model {model} Hz.</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Przed i po</translation>
    </message>
    <message>
        <source>Lines over the noise</source>
        <translation>Prążki ponad szumem</translation>
    </message>
    <message>
        <source>Lines in a length</source>
        <translation>Częstotliwość przestrzenna</translation>
    </message>
    <message>
        <source>Power over the noise, S</source>
        <translation>Moc względem szumu, S</translation>
    </message>
    <message>
        <source>strongest line</source>
        <translation>najsilniejszy prążek</translation>
    </message>
    <message>
        <source>threshold, T</source>
        <translation>próg, T</translation>
    </message>
    <message>
        <source>Before and after, in one scale, direction and grey</source>
        <translation>Przed i po, w tej samej skali, kierunku i szarości</translation>
    </message>
    <message>
        <source>Before, {rpm} rpm: no periodic marks found.</source>
        <translation>Przed, {rpm} obr/min: nie znaleziono śladów okresowych.</translation>
    </message>
    <message>
        <source>After, {rpm} rpm: no periodic marks found.</source>
        <translation>Po, {rpm} obr/min: nie znaleziono śladów okresowych.</translation>
    </message>
    <message>
        <source>Before, {rpm} rpm: no chatter marks above {limit} % of the feed marks.</source>
        <translation>Przed, {rpm} obr/min: brak śladów drgań powyżej {limit} % śladów posuwu.</translation>
    </message>
    <message>
        <source>After, {rpm} rpm: no chatter marks above {limit} % of the feed marks.</source>
        <translation>Po, {rpm} obr/min: brak śladów drgań powyżej {limit} % śladów posuwu.</translation>
    </message>
    <message>
        <source>Before, {rpm} rpm: chatter marks, {relative} times as strong as the feed marks.</source>
        <translation>Przed, {rpm} obr/min: ślady drgań, {relative} razy silniejsze niż ślady posuwu.</translation>
    </message>
    <message>
        <source>After, {rpm} rpm: chatter marks, {relative} times as strong as the feed marks.</source>
        <translation>Po, {rpm} obr/min: ślady drgań, {relative} razy silniejsze niż ślady posuwu.</translation>
    </message>
    <message>
        <source>Before, {rpm} rpm: marks of {frequency} ± {uncertainty} Hz (m = {m}, ε {phase}°), {relative} times as strong as the feed marks.</source>
        <translation>Przed, {rpm} obr/min: ślady {frequency} ± {uncertainty} Hz (m = {m}, ε {phase}°), {relative} razy silniejsze niż ślady posuwu.</translation>
    </message>
    <message>
        <source>After, {rpm} rpm: marks of {frequency} ± {uncertainty} Hz (m = {m}, ε {phase}°), {relative} times as strong as the feed marks.</source>
        <translation>Po, {rpm} obr/min: ślady {frequency} ± {uncertainty} Hz (m = {m}, ε {phase}°), {relative} razy silniejsze niż ślady posuwu.</translation>
    </message>
    <message>
        <source>By the rule N = 60 f/k chatter is worst at ν = 0 (bands along the axis), by the exact relation near ν = -¼ (steep bands, axial period 4 f). Here ν = {nu}, axial period {feeds} f: these marks speak for the exact relation.</source>
        <translation>Według reguły N = 60 f/k drgania są najsilniejsze przy ν = 0 (pasma wzdłuż osi), według zależności dokładnej blisko ν = -¼ (strome pasma, okres osiowy 4 f). Tu ν = {nu}, okres osiowy {feeds} f: te ślady przemawiają za zależnością dokładną.</translation>
    </message>
    <message>
        <source>By the rule N = 60 f/k chatter is worst at ν = 0 (bands along the axis), by the exact relation near ν = -¼ (steep bands, axial period 4 f). Here ν = {nu}: as the rule says, or a forced vibration.</source>
        <translation>Według reguły N = 60 f/k drgania są najsilniejsze przy ν = 0 (pasma wzdłuż osi), według zależności dokładnej blisko ν = -¼ (strome pasma, okres osiowy 4 f). Tu ν = {nu}: zgodnie z regułą albo drgania wymuszone.</translation>
    </message>
    <message>
        <source>By the rule N = 60 f/k chatter is worst at ν = 0 (bands along the axis), by the exact relation near ν = -¼ (steep bands, axial period 4 f). Here ν = {nu}: this picture decides for neither.</source>
        <translation>Według reguły N = 60 f/k drgania są najsilniejsze przy ν = 0 (pasma wzdłuż osi), według zależności dokładnej blisko ν = -¼ (strome pasma, okres osiowy 4 f). Tu ν = {nu}: ten obraz nie rozstrzyga na korzyść żadnej z nich.</translation>
    </message>
    <message>
        <source>Forced or regenerative? ν = {nu}: a whole number of waves in a revolution, or more, speaks for a forced vibration (out-of-round stock, jaws, bearings, gears).</source>
        <translation>Wymuszone czy regeneracyjne? ν = {nu}: całkowita liczba fal na obrót lub większa wskazuje na drgania wymuszone (nieokrągły półfabrykat, szczęki, łożyska, koła zębate).</translation>
    </message>
    <message>
        <source>Regenerative: ε = {phase}° lies between 180° and 360°, as chatter that feeds itself does.</source>
        <translation>Regeneracyjne: ε = {phase}° leży między 180° a 360°, jak przy drganiach samowzbudnych.</translation>
    </message>
    <message>
        <source>Forced or regenerative? ν = {nu}; its sign is open until the directions of feed and cut are given.</source>
        <translation>Wymuszone czy regeneracyjne? ν = {nu}; znak pozostaje nieustalony, dopóki nie podano kierunków posuwu i skrawania.</translation>
    </message>
    <message>
        <source>{waves} waves lie in the picture: it decides m = {m} by itself (measured {measured}).</source>
        <translation>Liczba fal w obrazie: {waves}; obraz sam rozstrzyga m = {m} (zmierzono {measured}).</translation>
    </message>
    <message>
        <source>Only {waves} waves lie in the picture: ν is sure, m = {m} is not (measured {measured}). Candidates: {all} Hz. Photograph the whole width of the part, or let a model choose.</source>
        <translation>Liczba fal w obrazie to tylko {waves}: ν jest pewne, m = {m} nie (zmierzono {measured}). Kandydaci: {all} Hz. Sfotografuj całą szerokość części albo pozwól wybrać modelowi.</translation>
    </message>
    <message>
        <source>A picture cannot tell heights: no roughness and no amplitude in µm are made from it, for its contrast depends on the light far more than on the surface. Strengths are compared only between pictures taken alike.</source>
        <translation>Z obrazu nie da się odczytać wysokości: nie wyznacza się z niego chropowatości ani amplitudy w µm, bo jego kontrast zależy od oświetlenia znacznie bardziej niż od powierzchni. Siłę śladów porównuje się tylko między obrazami wykonanymi w tych samych warunkach.</translation>
    </message>
    <message>
        <source>One surface in both pictures (response {response} of phase correlation).</source>
        <translation>Ta sama powierzchnia na obu obrazach (odpowiedź korelacji fazowej {response}).</translation>
    </message>
    <message>
        <source>Different surfaces (response {response}): aligned by scale and direction only, not registered.</source>
        <translation>Różne powierzchnie (odpowiedź {response}): wyrównane tylko skalą i kierunkiem, nie nałożone na siebie.</translation>
    </message>
    <message>
        <source>Different surfaces (response {response}), scale not known: aligned by direction only, not registered.</source>
        <translation>Różne powierzchnie (odpowiedź {response}), skala nieznana: wyrównane tylko kierunkiem, nie nałożone na siebie.</translation>
    </message>
    <message>
        <source>Speeds with whole waves in a revolution, N = 60 f_c / k</source>
        <translation>Prędkości z całkowitą liczbą fal na obrót, N = 60 f_c / k</translation>
    </message>
    <message>
        <source>Waves, k</source>
        <translation>Fale, k</translation>
    </message>
    <message>
        <source>What is seen</source>
        <translation>Co widać</translation>
    </message>
    <message>
        <source>Which vibration</source>
        <translation>Jakie to drgania</translation>
    </message>
    <message>
        <source>What a picture cannot say</source>
        <translation>Czego obraz nie powie</translation>
    </message>
    <message>
        <source>Proof of the copy</source>
        <translation>Weryfikacja kopii</translation>
    </message>
    <message>
        <source>a run of the chain</source>
        <translation>przebieg łańcucha</translation>
    </message>
    <message>
        <source>a chain that was run in this folder</source>
        <translation>łańcuch wykonany w tym folderze</translation>
    </message>
    <message>
        <source>✓ prediction agrees with the copy</source>
        <translation>✓ przewidywanie zgodne z kopią</translation>
    </message>
    <message>
        <source>✗ prediction disagrees with the copy</source>
        <translation>✗ przewidywanie niezgodne z kopią</translation>
    </message>
    <message>
        <source>Fitted to the copy</source>
        <translation>Dopasowano do kopii</translation>
    </message>
    <message>
        <source>Standard uncertainty [%]</source>
        <translation>Niepewność standardowa [%]</translation>
    </message>
    <message>
        <source>fitted to the copy</source>
        <translation>dopasowane do kopii</translation>
    </message>
    <message>
        <source>Stiffness and forces from the copy</source>
        <translation>Sztywność i siły z kopii</translation>
    </message>
    <message>
        <source>Where the files of the chain are.</source>
        <translation>Gdzie są pliki łańcucha.</translation>
    </message>
    <message>
        <source>Drawing confirmed by</source>
        <translation>Rysunek potwierdził</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Przebieg</translation>
    </message>
    <message>
        <source>Scan of the worn part</source>
        <translation>Skan zużytej części</translation>
    </message>
    <message>
        <source>Else that of the panel Recognise</source>
        <translation>Inaczej z panelu Rozpoznawanie</translation>
    </message>
    <message>
        <source>A confirmed one, in place of what is recognised; else that of the turning program</source>
        <translation>Zatwierdzony, zamiast rozpoznanego; inaczej z panelu Program tokarski</translation>
    </message>
    <message>
        <source>Else the spindle of the turning program</source>
        <translation>Inaczej wrzeciono z panelu Program tokarski</translation>
    </message>
    <message>
        <source>Else that of the turning program</source>
        <translation>Inaczej z panelu Program tokarski</translation>
    </message>
    <message>
        <source>Else that of Deflection</source>
        <translation>Inaczej z panelu Ugięcie</translation>
    </message>
    <message>
        <source>Scan of the copy</source>
        <translation>Skan kopii</translation>
    </message>
    <message>
        <source>Else the copy of Compare</source>
        <translation>Inaczej kopia z panelu Porównanie</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Łańcuch</translation>
    </message>
    <message>
        <source>The chain was run; its files are in {path}.</source>
        <translation>Łańcuch wykonano; jego pliki są w {path}.</translation>
    </message>
    <message>
        <source>Read off a photograph by the panel Surface. They may be missing.</source>
        <translation>Odczytane ze zdjęcia przez panel Powierzchnia. Można pominąć.</translation>
    </message>
    <message>
        <source>Let the model choose among the candidates: near {model} Hz</source>
        <translation>Niech wśród kandydatów wybierze model: blisko {model} Hz</translation>
    </message>
    <message>
        <source>The picture was made with {frequency} Hz: m = {m}, ν = {nu}</source>
        <translation>Obraz wytworzono z drganiami {frequency} Hz: m = {m}, ν = {nu}</translation>
    </message>
    <message>
        <source>The picture was made without vibration</source>
        <translation>Obraz wytworzono bez drgań</translation>
    </message>
    <message>
        <source>Picture (before)</source>
        <translation>Obraz (przed)</translation>
    </message>
    <message>
        <source>Picture after</source>
        <translation>Obraz po</translation>
    </message>
    <message>
        <source>The same surface after the speed was corrected, taken alike. It may be missing.</source>
        <translation>Ta sama powierzchnia po korekcie prędkości, sfotografowana w tych samych warunkach. Można pominąć.</translation>
    </message>
    <message>
        <source>A model to compare the marks with: UFF, CSV or MAT. It may be missing.</source>
        <translation>Model do porównania ze śladami: UFF, CSV lub MAT. Można pominąć.</translation>
    </message>
    <message>
        <source>Drop one or two photographs of a turned surface here, or let one be made (Make a picture).</source>
        <translation>Upuść tu jedno lub dwa zdjęcia toczonej powierzchni albo zleć wytworzenie obrazu (Wytwórz obraz).</translation>
    </message>
    <message>
        <source>Making the picture</source>
        <translation>Wytwarzanie obrazu</translation>
    </message>
    <message>
        <source>Speed after</source>
        <translation>Prędkość po</translation>
    </message>
    <message>
        <source>That the second surface was cut with; none: as the first.</source>
        <translation>Z którą skrawano drugą powierzchnię; brak: jak pierwszą.</translation>
    </message>
    <message>
        <source>Make a picture</source>
        <translation>Wytwórz obraz</translation>
    </message>
    <message>
        <source>For training: a picture is made from physics, with sliders, in place of the files.</source>
        <translation>Do szkolenia: zamiast plików obraz powstaje z praw fizyki, ustawiany suwakami.</translation>
    </message>
    <message>
        <source>Picture that is made</source>
        <translation>Wytwarzany obraz</translation>
    </message>
    <message>
        <source>{step}: a number of the dossier does not stand at {place} in {path}.</source>
        <translation>{step}: liczby z dokumentacji nie ma w miejscu {place} pliku {path}.</translation>
    </message>
    <message>
        <source>The photograph before is taken as cut at {speed_rpm} 1/min, the cutting speed of the job.</source>
        <translation>Przyjęto, że powierzchnię na zdjęciu przed toczono przy {speed_rpm} 1/min, prędkości skrawania z zadania.</translation>
    </message>
    <message>
        <source>The marks before are of {frequency_hz} ± {uncertainty_hz} Hz, the model&apos;s chatter there of {model_hz} Hz: {difference_percent} % apart.</source>
        <translation>Ślady przed mają {frequency_hz} ± {uncertainty_hz} Hz, drgania modelu w tym miejscu {model_hz} Hz: różnica {difference_percent} %.</translation>
    </message>
    <message>
        <source>The marks before are of {frequency_hz} ± {uncertainty_hz} Hz, the model&apos;s chatter there of {model_hz} Hz: {difference_percent} % apart. Machine, diameter, speed or number of waves may be wrong.</source>
        <translation>Ślady przed mają {frequency_hz} ± {uncertainty_hz} Hz, drgania modelu w tym miejscu {model_hz} Hz: różnica {difference_percent} %. Błędne mogą być maszyna, średnica, prędkość albo liczba fal.</translation>
    </message>
    <message>
        <source>Direction of feed in the photographs</source>
        <translation>Kierunek posuwu na zdjęciach</translation>
    </message>
    <message>
        <source>From right toward down; without it both signs of the marks stay open.</source>
        <translation>Od prawej ku dołowi; bez niego oba znaki śladów pozostają możliwe.</translation>
    </message>
    <message>
        <source>Direction of cut in the photographs</source>
        <translation>Kierunek skrawania na zdjęciach</translation>
    </message>
    <message>
        <source>Of later points of a track, the feed pointing right.</source>
        <translation>Późniejszych punktów śladu, przy posuwie skierowanym w prawo.</translation>
    </message>
    <message>
        <source>The copy: largest deviation {worst:3} mm, limit ± {tolerance:3} mm</source>
        <translation>Kopia: największa odchyłka {worst:3} mm, granica ± {tolerance:3} mm</translation>
    </message>
    <message>
        <source>The copy: largest deviation {worst:3} mm; no limit is given, so it is not judged</source>
        <translation>Kopia: największa odchyłka {worst:3} mm; nie podano granicy, więc nie jest oceniana</translation>
    </message>
    <message>
        <source>Row {row}: measured {measured:1} µm, predicted {predicted:1} µm, E_n {error:2}</source>
        <translation>Wiersz {row}: zmierzono {measured:1} µm, przewidziano {predicted:1} µm, E_n {error:2}</translation>
    </message>
    <message>
        <source>✗ predicted well, but the copy is out of its limit</source>
        <translation>✗ dobrze przewidziana, ale kopia jest poza granicą</translation>
    </message>
    <message>
        <source>? predicted well; the copy&apos;s limit is not decided</source>
        <translation>? dobrze przewidziana; granica kopii nierozstrzygnięta</translation>
    </message>
    <message>
        <source>? the files are not those of the dossier</source>
        <translation>? pliki nie są plikami z dokumentacji</translation>
    </message>
    <message>
        <source>Files or numbers that differ from the dossier: {count}</source>
        <translation>Pliki lub liczby inne niż w dokumentacji: {count}</translation>
    </message>
    <message>
        <source>Else that of Surface</source>
        <translation>Inaczej z panelu Powierzchnia</translation>
    </message>
    <message>
        <source>Power of the motor</source>
        <translation>Moc silnika</translation>
    </message>
    <message>
        <source>Cuts that need more than 80 % of it are remarked; empty: not looked at.</source>
        <translation>Przejścia, które potrzebują ponad 80 % tej mocy, wskazuje uwaga; puste: bez sprawdzania.</translation>
    </message>
    <message>
        <source>Efficiency</source>
        <translation>Sprawność</translation>
    </message>
    <message>
        <source>Of the way from the motor to the cut.</source>
        <translation>Na drodze od silnika do ostrza.</translation>
    </message>
    <message>
        <source>a thread runs out into the groove that is cut before it</source>
        <translation>gwint wybiega w rowek toczony przed nim</translation>
    </message>
    <message>
        <source>Nothing was written: what is there was not to be replaced.</source>
        <translation>Niczego nie zapisano: istniejących plików nie zastąpiono.</translation>
    </message>
    <message>
        <source>The program of clamping {clamping} calls tool {tool}, which is not in the job: what it cuts is not checked. Add the tool to the job.</source>
        <translation>Program zamocowania {clamping} wywołuje narzędzie {tool}, którego nie ma w zadaniu: to, co ono skrawa, nie jest sprawdzone. Dodaj narzędzie do zadania.</translation>
    </message>
    <message>
        <source>“{item}” is a program of clamping {clamping}; there is no such clamping here, so it is not used.</source>
        <translation>„{item}” to program zamocowania {clamping}; takiego zamocowania tu nie ma, więc nie jest użyty.</translation>
    </message>
    <message>
        <source>Tool {tool} turns z = {z_start_mm} … {z_end_mm} mm at {speed_rpm} 1/min (f_m {frequency_hz:1} Hz, lobe {lobe}).</source>
        <translation>Narzędzie {tool} toczy z = {z_start_mm} … {z_end_mm} mm przy {speed_rpm} obr/min (f_m {frequency_hz:1} Hz, worek {lobe}).</translation>
    </message>
    <message>
        <source>{operation} with tool {tool} takes about {power_kW:2} kW of the motor, {share_percent:0} % of the machine&apos;s {machine_kW} kW (efficiency {efficiency}; ± 25 %).</source>
        <translation>{operation} narzędziem {tool} wymaga od silnika około {power_kW:2} kW, {share_percent:0} % z {machine_kW} kW obrabiarki (sprawność {efficiency}; ± 25 %).</translation>
    </message>
    <message>
        <source>Tool {tool}: {what} of {name} from the library ({standing}): {source}.</source>
        <translation>Narzędzie {tool}: {what} {name} z biblioteki ({standing}): {source}.</translation>
    </message>
    <message>
        <source>Tool {tool}: the insert {insert} does not fit the holder {holder} (shape, clearance or length of the edge).</source>
        <translation>Narzędzie {tool}: płytka {insert} nie pasuje do oprawki {holder} (kształt, kąt przyłożenia albo długość krawędzi).</translation>
    </message>
    <message>
        <source>Posts of controls</source>
        <translation>Postprocesory</translation>
    </message>
    <message>
        <source>its row has another diameter</source>
        <translation>jego wiersz ma inną średnicę</translation>
    </message>
    <message>
        <source>its root does not fit its pitch</source>
        <translation>średnica rdzenia nie pasuje do skoku</translation>
    </message>
    <message>
        <source>the geometry</source>
        <translation>geometria</translation>
    </message>
    <message>
        <source>the outline</source>
        <translation>zarys</translation>
    </message>
    <message>
        <source>an allowance</source>
        <translation>naddatek</translation>
    </message>
    <message>
        <source>{path}: the part curves away across the picture and was not unrolled; the whole number of waves in a revolution is open.</source>
        <translation>{path}: część zakrzywia się w poprzek obrazu i nie została rozwinięta; całkowita liczba fal na obrót jest nieustalona.</translation>
    </message>
    <message>
        <source>{path}: neither feed marks nor a direction of feed tell where the axis lies; the part may curve away across the picture and was not unrolled.</source>
        <translation>{path}: ani ślady posuwu, ani kierunek posuwu nie mówią, gdzie leży oś; część może się zakrzywiać w poprzek obrazu i nie została rozwinięta.</translation>
    </message>
    <message>
        <source>The marks were not compared with the frequency response: {reason}</source>
        <translation>Śladów nie porównano z charakterystyką częstotliwościową: {reason}</translation>
    </message>
    <message>
        <source>That the surface was cut with; 0: not known.</source>
        <translation>Z jaką toczono powierzchnię; 0: nieznana.</translation>
    </message>
    <message>
        <source>Of the cut: one for all pictures, or one for each in their order; 0: not known.</source>
        <translation>Skrawania: jedna dla wszystkich zdjęć albo po jednej w ich kolejności; 0: nieznana.</translation>
    </message>
    <message>
        <source>Curved and not unrolled</source>
        <translation>Zakrzywiona i nierozwinięta</translation>
    </message>
    <message>
        <source>The part curves away across the picture and was not unrolled: ν is sure, m = {m} is not (measured {measured}). Candidates: {all} Hz. Let it be unrolled, or let a model choose.</source>
        <translation>Część zakrzywia się na zdjęciu i nie została rozwinięta: ν jest pewne, m = {m} nie (zmierzone {measured}). Możliwości: {all} Hz. Każ ją rozwinąć albo niech wybierze model.</translation>
    </message>
    <message>
        <source>Speeds by the marks, and by the model moved to the marks</source>
        <translation>Prędkości według śladów i według modelu przesuniętego do śladów</translation>
    </message>
    <message>
        <source>Whole waves, 60 f_c / k</source>
        <translation>Całkowite fale, 60 f_c / k</translation>
    </message>
    <message>
        <source>Best of the pocket, model</source>
        <translation>Najlepsza w kieszeni, model</translation>
    </message>
    <message>
        <source>Speed next: {speed} rpm, the best of pocket {k} by the exact relation, with the model moved to the frequency of the marks.</source>
        <translation>Następna prędkość: {speed} obr/min, najlepsza w kieszeni {k} według dokładnej zależności, z modelem przesuniętym do częstotliwości śladów.</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Pytanie</translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation>jeszcze bez odpowiedzi</translation>
    </message>
    <message>
        <source>D {diameter} mm, f {feed} mm, N {speed} rpm, feed to the right, cut downward: which frequency made these marks? Measure with the ruler, then f_c = n (m + ν).</source>
        <translation>D {diameter} mm, f {feed} mm, N {speed} obr/min, posuw w prawo, skrawanie w dół: jaka częstotliwość zostawiła te ślady? Zmierz linijką, potem f_c = n (m + ν).</translation>
    </message>
    <message>
        <source>{answer} Hz is right</source>
        <translation>{answer} Hz to dobra odpowiedź</translation>
    </message>
    <message>
        <source>{answer} Hz has ν with the other sign: look which way the bands lean</source>
        <translation>{answer} Hz ma przeciwny znak ν: zobacz, w którą stronę pochylają się pasy</translation>
    </message>
    <message>
        <source>{answer} Hz has ν right and m wrong by {k}: count the waves again</source>
        <translation>{answer} Hz ma dobre ν, a m błędne o {k}: policz fale jeszcze raz</translation>
    </message>
    <message>
        <source>{answer} Hz is a multiple or a part of the frequency</source>
        <translation>{answer} Hz to wielokrotność lub część częstotliwości</translation>
    </message>
    <message>
        <source>{answer} Hz is no reading of these marks</source>
        <translation>{answer} Hz nie jest odczytem tych śladów</translation>
    </message>
    <message>
        <source>How the light fell is not stated; state it in the field Light.</source>
        <translation>Nie podano, jak padało światło; podaj to w polu Światło.</translation>
    </message>
    <message>
        <source>Light, as stated: {light}</source>
        <translation>Światło, jak podano: {light}</translation>
    </message>
    <message>
        <source>That the first surface was cut with; none: not known.</source>
        <translation>Z jaką toczono pierwszą powierzchnię; brak: nieznana.</translation>
    </message>
    <message>
        <source>Where the light came from, for the report. Pictures are compared as if it had been the same.</source>
        <translation>Skąd padało światło, do raportu. Zdjęcia porównuje się tak, jakby było jednakowe.</translation>
    </message>
    <message>
        <source>Both pictures taken alike</source>
        <translation>Oba zdjęcia wykonane tak samo</translation>
    </message>
    <message>
        <source>One scale and one direction of feed for both.</source>
        <translation>Jedna skala i jeden kierunek posuwu dla obu.</translation>
    </message>
    <message>
        <source>Scale after</source>
        <translation>Skala po</translation>
    </message>
    <message>
        <source>Of the second picture, where it was taken otherwise; none: as the first.</source>
        <translation>Drugiego zdjęcia, jeśli wykonano je inaczej; brak: jak pierwszego.</translation>
    </message>
    <message>
        <source>Direction of feed after</source>
        <translation>Kierunek posuwu po</translation>
    </message>
    <message>
        <source>In the second picture, where it was taken otherwise; none: as in the first.</source>
        <translation>Na drugim zdjęciu, jeśli wykonano je inaczej; brak: jak na pierwszym.</translation>
    </message>
    <message>
        <source>Second picture to the right</source>
        <translation>Drugie zdjęcie w prawo</translation>
    </message>
    <message>
        <source>By two clicks on one place in both, in pixels of the comparison.</source>
        <translation>Z dwóch kliknięć w jedno miejsce na obu, w pikselach porównania.</translation>
    </message>
    <message>
        <source>Second picture down</source>
        <translation>Drugie zdjęcie w dół</translation>
    </message>
    <message>
        <source>The picture&apos;s vibration is to be found.</source>
        <translation>Trzeba znaleźć drgania, które zostawiły ślady na obrazie.</translation>
    </message>
    <message>
        <source>Number of the question</source>
        <translation>Numer pytania</translation>
    </message>
    <message>
        <source>Another number is another picture.</source>
        <translation>Inny numer to inny obraz.</translation>
    </message>
    <message>
        <source>Frequency that was read off the picture.</source>
        <translation>Częstotliwość odczytana z obrazu.</translation>
    </message>
    <message>
        <source>Clamping {clamping}: roughing is written as moves and not as a cycle, {reason}.</source>
        <translation>Zamocowanie {clamping}: obróbka zgrubna jest zapisana jako ruchy, a nie jako cykl: {reason}.</translation>
    </message>
    <message>
        <source>as the control&apos;s post states it</source>
        <translation>jak podaje postprocesor sterowania</translation>
    </message>
    <message>
        <source>every pass as moves</source>
        <translation>każde przejście jako ruchy</translation>
    </message>
    <message>
        <source>cycles G71 and G70</source>
        <translation>cykle G71 i G70</translation>
    </message>
    <message>
        <source>Roughing and finish</source>
        <translation>Obróbka zgrubna i wykańczająca</translation>
    </message>
    <message>
        <source>In cycles the control lays the passes itself; the check reads them as this program expands them.</source>
        <translation>W cyklach przejścia układa sterowanie; sprawdzenie czyta je tak, jak rozwija je ten program.</translation>
    </message>
    <message>
        <source>braces around first, last, depth, retract, x_allowance, z_allowance, feed, or what other templates name</source>
        <translation>nawiasy klamrowe wokół first, last, depth, retract, x_allowance, z_allowance, feed albo tego, co nazywają inne szablony</translation>
    </message>
    <message>
        <source>none or g71_g70</source>
        <translation>none albo g71_g70</translation>
    </message>
    <message>
        <source>none, for a control that has no G71; or the templates of rough_cycle</source>
        <translation>none, dla sterowania bez G71; albo szablony w rough_cycle</translation>
    </message>
    <message>
        <source>rough in a cycle (G71)</source>
        <translation>obrabiać zgrubnie w cyklu (G71)</translation>
    </message>
    <message>
        <source>the numbers of blocks begin anew within it</source>
        <translation>numery bloków zaczynają się w nim od nowa</translation>
    </message>
    <message>
        <source>roughing, its last pass and one finish do not follow each other</source>
        <translation>obróbka zgrubna, jej ostatnie przejście i jedna obróbka wykańczająca nie następują po sobie</translation>
    </message>
    <message>
        <source>the roughing insert cannot follow a wall</source>
        <translation>płytka zgrubna nie może iść wzdłuż ściany</translation>
    </message>
    <message>
        <source>its passes have speeds of their own</source>
        <translation>jej przejścia mają własne prędkości</translation>
    </message>
    <message>
        <source>its contour is too short</source>
        <translation>jej kontur jest za krótki</translation>
    </message>
    <message>
        <source>its contour falls somewhere</source>
        <translation>jej kontur gdzieś opada</translation>
    </message>
    <message>
        <source>there is no more than one pass</source>
        <translation>jest tylko jedno przejście</translation>
    </message>
    <message>
        <source>RMS of the diameters [µm]</source>
        <translation>RMS średnic [µm]</translation>
    </message>
    <message>
        <source>A part of the program cannot be loaded: {file} ({reason}). Is the installation complete?</source>
        <translation>Nie można wczytać części programu: {file} ({reason}). Czy instalacja jest kompletna?</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Sprawdź</translation>
    </message>
    <message>
        <source>The program is written for it: a post that is built in, or POST.json.</source>
        <translation>Dla niego pisany jest program: wbudowany postprocesor albo POST.json.</translation>
    </message>
    <message>
        <source>The part (SHAFT.json, STEP, CSV) with --job, or a job that holds its shaft.</source>
        <translation>Część (SHAFT.json, STEP, CSV) z --job albo zadanie, które zawiera swój wałek.</translation>
    </message>
    <message>
        <source>POST.json, in place of a control that is built in.</source>
        <translation>POST.json, zamiast wbudowanego sterowania.</translation>
    </message>
    <message>
        <source>In place of the planned program of the first clamping; it is checked like it.</source>
        <translation>Zamiast ułożonego programu pierwszego zamocowania; jest sprawdzany tak samo.</translation>
    </message>
    <message>
        <source>Its springs (SPINDLE.json), instead of the chuck in the set-up.</source>
        <translation>Jego sprężyny (SPINDLE.json), zamiast uchwytu z ustawienia.</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabela (*.csv)</translation>
    </message>
    <message>
        <source>Corrected program…</source>
        <translation>Skorygowany program…</translation>
    </message>
    <message>
        <source>NC program (*.nc *.ngc *.mpf *.tap)</source>
        <translation>Program NC (*.nc *.ngc *.mpf *.tap)</translation>
    </message>
    <message>
        <source>Correction along the work (CSV)…</source>
        <translation>Korekcja wzdłuż przedmiotu (CSV)…</translation>
    </message>
    <message>
        <source>Error along the work (CSV)…</source>
        <translation>Błąd wzdłuż przedmiotu (CSV)…</translation>
    </message>
    <message>
        <source>Set-up as changed here (JSON)…</source>
        <translation>Ustawienie zmienione tutaj (JSON)…</translation>
    </message>
    <message>
        <source>Set-up (*.json)</source>
        <translation>Ustawienie (*.json)</translation>
    </message>
    <message>
        <source>Moves of the tool (CSV)…</source>
        <translation>Ruchy narzędzia (CSV)…</translation>
    </message>
    <message>
        <source>Fagor</source>
        <translation>Fagor</translation>
    </message>
    <message>
        <source>Heidenhain</source>
        <translation>Heidenhain</translation>
    </message>
    <message>
        <source>Mazatrol</source>
        <translation>Mazatrol</translation>
    </message>
    <message>
        <source>Okuma OSP</source>
        <translation>Okuma OSP</translation>
    </message>
    <message>
        <source>corner radius</source>
        <translation>promień naroża</translation>
    </message>
    <message>
        <source>{former} is the older name of {key}, and both are stated; keep one of them.</source>
        <translation>{former} to starsza nazwa klucza {key}, a podano oba; zostaw jeden z nich.</translation>
    </message>
    <message>
        <source>boring bar</source>
        <translation>wytaczak</translation>
    </message>
    <message>
        <source>threading insert</source>
        <translation>płytka do gwintów</translation>
    </message>
    <message>
        <source>Of the corner that cuts; of both corners of a blade.</source>
        <translation>Naroża, które skrawa; obu naroży przecinaka.</translation>
    </message>
    <message>
        <source>Of a blade.</source>
        <translation>Przecinaka.</translation>
    </message>
    <message>
        <source>Of a drill.</source>
        <translation>Wiertła.</translation>
    </message>
    <message>
        <source>How deep a blade cuts, on radius; length of a drill or a boring bar.</source>
        <translation>Jak głęboko wcina się przecinak, na promieniu; długość wiertła lub wytaczaka.</translation>
    </message>
    <message>
        <source>Control of your own</source>
        <translation>Własne sterowanie</translation>
    </message>
    <message>
        <source>Program in place of the planned one</source>
        <translation>Program w miejsce zaplanowanego</translation>
    </message>
    <message>
        <source>turning program</source>
        <translation>program tokarski</translation>
    </message>
    <message>
        <source>{part}, clamping {clamping}</source>
        <translation>{part}, zamocowanie {clamping}</translation>
    </message>
    <message>
        <source>part at z {from_mm:1}-{to_mm:1} mm</source>
        <translation>część przy z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>{program}, corrected</source>
        <translation>{program}, skorygowany</translation>
    </message>
    <message>
        <source>its faces are free-form surfaces that are exactly no plane, cylinder, cone, sphere or torus</source>
        <translation>jej ściany są powierzchniami swobodnymi, które nie są dokładnie płaszczyzną, walcem, stożkiem, kulą ani torusem</translation>
    </message>
    <message>
        <source>The drawing has a feature that the check does not look at: {feature} {designation} at z = {z_start_mm} … {z_end_mm} mm.</source>
        <translation>Rysunek zawiera element, którego kontrola nie sprawdza: {feature} {designation} przy z = {z_start_mm} … {z_end_mm} mm.</translation>
    </message>
    <message>
        <source>Before line {line}: tool {tool} is called {distance_mm:1} mm from the work or what holds it; the turret is not modelled.</source>
        <translation>Przed wierszem {line}: narzędzie {tool} jest wywoływane {distance_mm:1} mm od przedmiotu lub jego mocowania; głowica nie jest modelowana.</translation>
    </message>
    <message>
        <source>The program stops for the work to be cut off to {length_mm:2} mm; it is checked with that length.</source>
        <translation>Program zatrzymuje się, by przedmiot obciąć na {length_mm:2} mm; sprawdza się go z tą długością.</translation>
    </message>
    <message>
        <source>Assumed: the work of the second clamping is cut off to {length_mm:2} mm. Neither the job nor the program says so.</source>
        <translation>Przyjęto: przedmiot drugiego zamocowania jest obcięty na {length_mm:2} mm. Nie mówi tego ani zadanie, ani program.</translation>
    </message>
    <message>
        <source>end that was not cut off</source>
        <translation>nieobcięty koniec</translation>
    </message>
    <message>
        <source>Length of the work</source>
        <translation>Długość przedmiotu</translation>
    </message>
    <message>
        <source>Before the second clamping, from the finished face; empty: as a stop of the program or the job states it.</source>
        <translation>Przed drugim zamocowaniem, od gotowego czoła; puste: jak podaje zatrzymanie programu lub zadanie.</translation>
    </message>
    <message>
        <source>? not all that is drawn is checked</source>
        <translation>? nie wszystko z rysunku jest sprawdzone</translation>
    </message>
    <message>
        <source>gouge {gouge_um:2} µm · places with material left: {rest} · findings: {findings} · drawn, but not checked: {not_checked} ({feature})</source>
        <translation>podcięcie {gouge_um:2} µm · miejsca z pozostawionym materiałem: {rest} · ustalenia: {findings} · na rysunku, lecz niesprawdzone: {not_checked} ({feature})</translation>
    </message>
    <message>
        <source>spline</source>
        <translation>wielowypust</translation>
    </message>
    <message>
        <source>hexagon</source>
        <translation>sześciokąt</translation>
    </message>
    <message>
        <source>square</source>
        <translation>czworokąt</translation>
    </message>
    <message>
        <source>bolt circle</source>
        <translation>otwory na okręgu</translation>
    </message>
    <message>
        <source>eccentric</source>
        <translation>mimośród</translation>
    </message>
    <message>
        <source>The check of the written program found {count} finding(s) and a gouge of {gouge_um:2} µm; no program was written. The first: {operation}, tool {tool}, {kind} at z = {z_mm:2} mm, line {program_line}.</source>
        <translation>Kontrola zapisanego programu: ustalenia: {count}, podcięcie {gouge_um:2} µm; programu nie zapisano. Pierwsze: {operation}, narzędzie {tool}, {kind} przy z = {z_mm:2} mm, wiersz {program_line}.</translation>
    </message>
    <message>
        <source>The end is not faced, {face_mm} mm stay: the main edge of every insert would run below the face (entering angle below 90°).</source>
        <translation>Czoło nie jest planowane, zostaje {face_mm} mm: główna krawędź każdej płytki szłaby poniżej czoła (kąt przystawienia poniżej 90°).</translation>
    </message>
    <message>
        <source>The bore of ⌀{diameter_mm} mm at z = {z_start_mm} … {z_end_mm} mm is not in the program: nothing that is planned makes it.</source>
        <translation>Otworu ⌀{diameter_mm} mm przy z = {z_start_mm} … {z_end_mm} mm nie ma w programie: nic z planu go nie wykonuje.</translation>
    </message>
    <message>
        <source>The drawing has a feature that is not in the program: {feature} {designation} at z = {z_start_mm} … {z_end_mm} mm.</source>
        <translation>Rysunek zawiera element, którego nie ma w programie: {feature} {designation} przy z = {z_start_mm} … {z_end_mm} mm.</translation>
    </message>
    <message>
        <source>The second clamping begins with a stop: the work is to be cut off to {length_mm:2} mm before it, from the finished face; the first program does not part it off.</source>
        <translation>Drugie zamocowanie zaczyna się zatrzymaniem: przedmiot trzeba przedtem obciąć na {length_mm:2} mm od gotowego czoła; pierwszy program go nie odcina.</translation>
    </message>
    <message>
        <source>Cut off first to</source>
        <translation>Najpierw obciąć na</translation>
    </message>
    <message>
        <source>its insert would cut into the drawing</source>
        <translation>jego płytka wcięłaby się w rysunek</translation>
    </message>
    <message>
        <source>a move that was not planned</source>
        <translation>ruch, którego nie planowano</translation>
    </message>
    <message>
        <source>✗ not all that is drawn is made</source>
        <translation>✗ nie wszystko z rysunku jest wykonane</translation>
    </message>
    <message>
        <source>{setups} clamping(s) · {time_min:1} min · gouge {gouge_um:2} µm · findings: {findings} · places with material left: {rest} · drawn, but not in the program: {not_made} ({feature})</source>
        <translation>zamocowania: {setups} · {time_min:1} min · podcięcie {gouge_um:2} µm · ustalenia: {findings} · miejsca z pozostawionym materiałem: {rest} · na rysunku, lecz nie w programie: {not_made} ({feature})</translation>
    </message>
    <message>
        <source>Drawn, but not in the program</source>
        <translation>Na rysunku, lecz nie w programie</translation>
    </message>
    <message>
        <source>call a tool by a number above 99</source>
        <translation>wywołać narzędzie o numerze powyżej 99</translation>
    </message>
    <message>
        <source>a dialect: fanuc, fanuc_b, fanuc_c, haas, sinumerik or linuxcnc</source>
        <translation>dialekt: fanuc, fanuc_b, fanuc_c, haas, sinumerik lub linuxcnc</translation>
    </message>
    <message>
        <source>Not in the program: {feature} {designation} · z {z_start_mm:2}-{z_end_mm:2} mm</source>
        <translation>Nie w programie: {feature} {designation} · z {z_start_mm:2}-{z_end_mm:2} mm</translation>
    </message>
    <message>
        <source>{place}: “{found}” is not modelled. It could change the result, which is undecided (such places: {count}).</source>
        <translation>{place}: „{found}” nie jest modelowane. Mogłoby zmienić wynik, który jest nierozstrzygnięty (takich miejsc: {count}).</translation>
    </message>
    <message>
        <source>Line {line}: a pass in a bore is neither predicted nor corrected; its material stays, and nothing is said of its diameter.</source>
        <translation>Wiersz {line}: przejścia w otworze nie przewiduje się ani nie koryguje; jego materiał zostaje i nic nie mówi się o jego średnicy.</translation>
    </message>
    <message>
        <source>Blocks behind “/”, first in line {line}, are taken as run. Where they are skipped, later passes are deeper than those that were corrected.</source>
        <translation>Bloki za „/”, pierwszy w wierszu {line}, przyjęto jako wykonane. Gdzie są pomijane, późniejsze przejścia są głębsze niż te skorygowane.</translation>
    </message>
    <message>
        <source>it is an arc that turns back along z</source>
        <translation>to łuk, który zawraca wzdłuż z</translation>
    </message>
    <message>
        <source>it is an arc that ends where a corrected pass begins</source>
        <translation>to łuk, który kończy się tam, gdzie zaczyna się skorygowane przejście</translation>
    </message>
    <message>
        <source>a pass in a bore</source>
        <translation>przejście w otworze</translation>
    </message>
    <message>
        <source>The noise of a point is estimated as {sigma_um} µm. Assumed: what no smooth form explains is noise; state the uncertainty of a point where it is known.</source>
        <translation>Szum punktu oszacowano na {sigma_um} µm. Przyjęto: co nie jest gładkim kształtem, jest szumem; gdzie niepewność punktu jest znana, należy ją podać.</translation>
    </message>
    <message>
        <source>{value_um} µm exceeds the limit of {limit_um} µm by less than its uncertainty of {uncertainty_um} µm: simple acceptance counts as form what may be noise.</source>
        <translation>{value_um} µm przekracza granicę {limit_um} µm o mniej niż swoją niepewność {uncertainty_um} µm: prosta akceptacja liczy jako kształt to, co może być szumem.</translation>
    </message>
    <message>
        <source>Points at exactly {x_mm}, {y_mm}, {z_mm} mm, left out: {count}. Programs write one place for all that was not measured.</source>
        <translation>Punkty dokładnie w {x_mm}, {y_mm}, {z_mm} mm, pominięte: {count}. Programy zapisują jedno miejsce dla wszystkiego, czego nie zmierzono.</translation>
    </message>
    <message>
        <source>Fanuc (G code systems A, B and C), Haas, Sinumerik or LinuxCNC</source>
        <translation>Fanuc (systemy kodów G: A, B i C), Haas, Sinumerik lub LinuxCNC</translation>
    </message>
    <message>
        <source>Fanuc, system B</source>
        <translation>Fanuc, system B</translation>
    </message>
    <message>
        <source>Fanuc, system C</source>
        <translation>Fanuc, system C</translation>
    </message>
    <message>
        <source>Philips CNC 3000</source>
        <translation>Philips CNC 3000</translation>
    </message>
    <message>
        <source>Sinumerik 810, 820 or 850</source>
        <translation>Sinumerik 810, 820 lub 850</translation>
    </message>
    <message>
        <source>Sinumerik 802</source>
        <translation>Sinumerik 802</translation>
    </message>
    <message>
        <source>The program may be for {first} or for {second}, which read its numbers differently; state the control: {choices}.</source>
        <translation>Program może być dla {first} albo dla {second}, które inaczej czytają jego liczby; proszę podać sterowanie: {choices}.</translation>
    </message>
    <message>
        <source>The block {found} stands in lines {first} and {second}: which one the cycle means is not clear.</source>
        <translation>Blok {found} stoi w wierszach {first} i {second}: nie wiadomo, który ma na myśli cykl.</translation>
    </message>
    <message>
        <source>“{found}” leads {distance_m:0} m away; at most {most_m:0} m are read.</source>
        <translation>„{found}” prowadzi {distance_m:0} m dalej; czyta się najwyżej {most_m:0} m.</translation>
    </message>
    <message>
        <source>The cycle makes {found} passes; at most {most} are read.</source>
        <translation>Liczba przejść cyklu: {found}; czyta się najwyżej {most}.</translation>
    </message>
    <message>
        <source>The file holds no block of a program.</source>
        <translation>Plik nie zawiera żadnego bloku programu.</translation>
    </message>
    <message>
        <source>“{word}” needs {found}, to which the program gives no value.</source>
        <translation>„{word}” potrzebuje {found}, której program nie nadaje wartości.</translation>
    </message>
    <message>
        <source>The block “{block}” may not be changed: {word} {reason}.</source>
        <translation>Bloku „{block}” nie wolno zmienić: {word} {reason}.</translation>
    </message>
    <message>
        <source>P and Q, which name its contour, follow nowhere</source>
        <translation>nigdzie nie następują P i Q, które wskazują jego kontur</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>as before</source>
        <translation>jak dotąd</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>cal</translation>
    </message>
    <message>
        <source>mm/min</source>
        <translation>mm/min</translation>
    </message>
    <message>
        <source>the line behind it states no angle, X and Z</source>
        <translation>następna prosta nie podaje kąta, X i Z</translation>
    </message>
    <message>
        <source>both lines are parallel</source>
        <translation>obie proste są równoległe</translation>
    </message>
    <message>
        <source>the line never reaches its end</source>
        <translation>prosta nigdy nie osiąga swojego końca</translation>
    </message>
    <message>
        <source>X and Z state another angle</source>
        <translation>X i Z podają inny kąt</translation>
    </message>
    <message>
        <source>may shape its end or its path</source>
        <translation>może kształtować jego koniec lub drogę</translation>
    </message>
    <message>
        <source>its coordinates are turned, scaled or mirrored</source>
        <translation>jego współrzędne są obrócone, przeskalowane lub odbite</translation>
    </message>
    <message>
        <source>its radius is computed</source>
        <translation>jego promień jest obliczany</translation>
    </message>
    <message>
        <source>it is an arc of more than half a circle</source>
        <translation>to łuk większy niż półokrąg</translation>
    </message>
    <message>
        <source>neither a radius nor a centre states its arc</source>
        <translation>łuku nie podaje ani promień, ani środek</translation>
    </message>
    <message>
        <source>its centre is computed</source>
        <translation>jego środek jest obliczany</translation>
    </message>
    <message>
        <source>where the blocks behind “/” are skipped it begins or ends elsewhere</source>
        <translation>gdy bloki za „/” są pomijane, zaczyna się lub kończy gdzie indziej</translation>
    </message>
    <message>
        <source>would stop it before its end</source>
        <translation>zatrzymałoby go przed końcem</translation>
    </message>
    <message>
        <source>Arc tolerance</source>
        <translation>Tolerancja łuku</translation>
    </message>
    <message>
        <source>An arc may end so far off the circle of its centre; it is a note. Farther off it is an error.</source>
        <translation>O tyle koniec łuku może leżeć poza okręgiem swojego środka: to uwaga. Dalej to błąd.</translation>
    </message>
    <message>
        <source>The unit “{found}” is not known; expected {expected}.</source>
        <translation>Jednostka „{found}” nie jest znana; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>{path}: none of its responses is that of a driving point, where response and force share node and direction. That of {used} is a cross response: depths and speeds by it are not those of the cutting point.</source>
        <translation>{path}: żadna z odpowiedzi nie jest odpowiedzią punktu wymuszenia, gdzie odpowiedź i siła mają wspólny węzeł i kierunek. {used} to odpowiedź skrośna: głębokości i prędkości z niej nie dotyczą punktu skrawania.</translation>
    </message>
    <message>
        <source>{path}: lines of text outside the data sets, not used: {count}, the first at line {line}.</source>
        <translation>{path}: wiersze tekstu poza zbiorami danych, nieużyte: {count}, pierwszy w wierszu {line}.</translation>
    </message>
    <message>
        <source>{path}: the file states {um_per_px} µm per pixel; used only when it is given as the scale.</source>
        <translation>{path}: plik podaje {um_per_px} µm na piksel; używane tylko, gdy podano to jako skalę.</translation>
    </message>
    <message>
        <source>Found the key {found}, expected {key}.</source>
        <translation>Znaleziono klucz {found}, oczekiwano {key}.</translation>
    </message>
    <message>
        <source>The unit of the angle is not known: found “{found}”, expected {expected}.</source>
        <translation>Jednostka kąta nie jest znana: znaleziono „{found}”, oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>Line {line}, column {column}: the key {key} is not known; what it states is not used.</source>
        <translation>Wiersz {line}, kolumna {column}: klucz {key} nie jest znany; to, co podaje, nie jest używane.</translation>
    </message>
    <message>
        <source>The sizes of the two parts differ by about {factor}, as if one were in another unit of length; --reference-unit and --copy-unit rule one file each.</source>
        <translation>Rozmiary obu części różnią się około {factor} razy, jakby jedna była w innej jednostce długości; --reference-unit i --copy-unit dotyczą po jednym pliku.</translation>
    </message>
    <message>
        <source>{path}: “{found}” is no certain unit of an angle; read as {unit} because it runs over {extent}.</source>
        <translation>{path}: „{found}” nie jest pewną jednostką kąta; odczytano jako {unit}, bo obejmuje {extent}.</translation>
    </message>
    <message>
        <source>deg, rad, mrad, gon, rev, arcmin or arcsec</source>
        <translation>deg, rad, mrad, gon, rev, arcmin lub arcsec</translation>
    </message>
    <message>
        <source>a surface height map (SDF, BCR)</source>
        <translation>mapa wysokości powierzchni (SDF, BCR)</translation>
    </message>
    <message>
        <source>a PTX scan</source>
        <translation>skan PTX</translation>
    </message>
    <message>
        <source>a TDMS measurement of LabVIEW</source>
        <translation>pomiar TDMS programu LabVIEW</translation>
    </message>
    <message>
        <source>a NumPy array (NPY)</source>
        <translation>tablica NumPy (NPY)</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <translation>plik HDF5</translation>
    </message>
    <message>
        <source>a NetCDF file</source>
        <translation>plik NetCDF</translation>
    </message>
    <message>
        <source>an MDF measurement</source>
        <translation>pomiar MDF</translation>
    </message>
    <message>
        <source>a FLAC recording</source>
        <translation>nagranie FLAC</translation>
    </message>
    <message>
        <source>an Ogg recording</source>
        <translation>nagranie Ogg</translation>
    </message>
    <message>
        <source>a surface of Digital Surf (SUR)</source>
        <translation>powierzchnia Digital Surf (SUR)</translation>
    </message>
    <message>
        <source>a Gwyddion surface</source>
        <translation>powierzchnia Gwyddion</translation>
    </message>
    <message>
        <source>an Office document</source>
        <translation>dokument biurowy</translation>
    </message>
    <message>
        <source>a glTF mesh</source>
        <translation>siatka glTF</translation>
    </message>
    <message>
        <source>a WAV recording</source>
        <translation>nagranie WAV</translation>
    </message>
    <message>
        <source>a LabVIEW measurement (LVM)</source>
        <translation>pomiar programu LabVIEW (LVM)</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
    <message>
        <source>values</source>
        <translation>wartości</translation>
    </message>
    <message>
        <source>the place of what follows</source>
        <translation>położenie tego, co następuje</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>ruchy</translation>
    </message>
    <message>
        <source>? not all of it was understood</source>
        <translation>? nie wszystko zrozumiano</translation>
    </message>
    <message>
        <source>Not modelled, by line: {places}. It could change what is shown here.</source>
        <translation>Niemodelowane, według wierszy: {places}. Mogłoby to zmienić to, co tu widać.</translation>
    </message>
    <message>
        <source>Line {line}: “{word}” is not modelled; it can change {what}</source>
        <translation>Wiersz {line}: „{word}” nie jest modelowane; może zmienić: {what}</translation>
    </message>
    <message>
        <source>What was not understood, and what was assumed</source>
        <translation>Czego nie zrozumiano i co przyjęto</translation>
    </message>
    <message>
        <source>Not modelled</source>
        <translation>Niemodelowane</translation>
    </message>
    <message>
        <source>Word</source>
        <translation>Słowo</translation>
    </message>
    <message>
        <source>It can change</source>
        <translation>Może zmienić</translation>
    </message>
    <message>
        <source>Assumed</source>
        <translation>Przyjęte</translation>
    </message>
    <message>
        <source>Unit of the reference</source>
        <translation>Jednostka wzorca</translation>
    </message>
    <message>
        <source>Rules over --unit for the reference, where it states none.</source>
        <translation>Ma pierwszeństwo przed --unit dla wzorca, który nie podaje jednostki.</translation>
    </message>
    <message>
        <source>Unit of the copy</source>
        <translation>Jednostka kopii</translation>
    </message>
    <message>
        <source>Rules over --unit for the copy, where it states none.</source>
        <translation>Ma pierwszeństwo przed --unit dla kopii, która nie podaje jednostki.</translation>
    </message>
    <message>
        <source>Without a date</source>
        <translation>Bez daty</translation>
    </message>
    <message>
        <source>No date in drawing, DXF and STEP: the same shaft gives the same bytes.</source>
        <translation>Bez daty w rysunku, DXF i STEP: ten sam wał daje te same bajty.</translation>
    </message>
    <message>
        <source>“{found}” is not modelled and could change the result, so nothing is written on it.</source>
        <translation>„{found}” nie jest modelowane i mogłoby zmienić wynik, więc niczego się na nim nie zapisuje.</translation>
    </message>
    <message>
        <source>“{word}” is not modelled; it can change {what}</source>
        <translation>„{word}” nie jest modelowane; może zmienić: {what}</translation>
    </message>
    <message>
        <source>The first frequency; not stated: that of the spindle&apos;s table, else 50.</source>
        <translation>Pierwsza częstotliwość; gdy jej nie podano: z tablicy wrzeciona, inaczej 50.</translation>
    </message>
    <message>
        <source>The last frequency; not stated: that of the spindle&apos;s table, else 5000.</source>
        <translation>Ostatnia częstotliwość; gdy jej nie podano: z tablicy wrzeciona, inaczej 5000.</translation>
    </message>
    <message>
        <source>speeds that the lobes show</source>
        <translation>prędkości, które pokazują krzywe workowe</translation>
    </message>
    <message>
        <source>Recommended: {speed:0} 1/min, where no lobe limits the depth</source>
        <translation>Zalecane: {speed:0} 1/min, gdzie żaden worek nie ogranicza głębokości</translation>
    </message>
    <message>
        <source>No speed from {from:0} to {to:0} 1/min is stable at {depth:3} ×; the most is {limit:3} × at {speed:0} 1/min</source>
        <translation>Żadna prędkość od {from:0} do {to:0} 1/min nie jest stabilna przy {depth:3} ×; najwięcej to {limit:3} × przy {speed:0} 1/min</translation>
    </message>
    <message>
        <source>No speed from {from:0} to {to:0} 1/min is stable at {depth_mm:3+} mm; the most is {limit_mm:3+} mm at {speed:0} 1/min</source>
        <translation>Żadna prędkość od {from:0} do {to:0} 1/min nie jest stabilna przy {depth_mm:3+} mm; najwięcej to {limit_mm:3+} mm przy {speed:0} 1/min</translation>
    </message>
    <message>
        <source>At {speed:0} 1/min no deeper than {limit:3} ×</source>
        <translation>Przy {speed:0} 1/min nie głębiej niż {limit:3} ×</translation>
    </message>
    <message>
        <source>At {speed:0} 1/min no deeper than {limit_mm:3+} mm</source>
        <translation>Przy {speed:0} 1/min nie głębiej niż {limit_mm:3+} mm</translation>
    </message>
    <message>
        <source>The most is {limit:3} × at {speed:0} 1/min</source>
        <translation>Najwięcej to {limit:3} × przy {speed:0} 1/min</translation>
    </message>
    <message>
        <source>The most is {limit_mm:3+} mm at {speed:0} 1/min</source>
        <translation>Najwięcej to {limit_mm:3+} mm przy {speed:0} 1/min</translation>
    </message>
    <message>
        <source>Limit and lobes (CSV)…</source>
        <translation>Granica i worki (CSV)…</translation>
    </message>
    <message>
        <source>Its receptance is computed, on its machine where a spindle is given: SHAFT.json or a stock file.</source>
        <translation>Jego receptancja jest obliczana, na maszynie, gdy podano wrzeciono: SHAFT.json albo plik półfabrykatu.</translation>
    </message>
    <message>
        <source>Frequency response, shaft or modes</source>
        <translation>Charakterystyka częstotliwościowa, wał albo postacie</translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation>Symulacja</translation>
    </message>
    <message>
        <source>the cutting coefficient for the depth</source>
        <translation>współczynnik skrawania dla głębokości</translation>
    </message>
    <message>
        <source>the depth of cut for the coefficient</source>
        <translation>głębokość skrawania dla współczynnika</translation>
    </message>
    <message>
        <source>the diameter of the bar</source>
        <translation>średnica pręta</translation>
    </message>
    <message>
        <source>the overhang of the bar</source>
        <translation>wysięg pręta</translation>
    </message>
    <message>
        <source>On the radius: the speed is judged by it, with the cutting coefficient.</source>
        <translation>Na promieniu: według niej ocenia się prędkość, razem ze współczynnikiem skrawania.</translation>
    </message>
    <message>
        <source>Force along the chip thickness over its area; with the depth.</source>
        <translation>Siła wzdłuż grubości wióra przez jego przekrój; razem z głębokością.</translation>
    </message>
    <message>
        <source>Of a plain bar of the diameter, from the chuck to its free end; in place of a shaft.</source>
        <translation>Gładkiego pręta o tej średnicy, od uchwytu do swobodnego końca; zamiast wału.</translation>
    </message>
    <message>
        <source>Speed that bears the most</source>
        <translation>Prędkość o największej granicy</translation>
    </message>
    <message>
        <source>No lobe limits the depth here · instead of {selected}</source>
        <translation>Żaden worek nie ogranicza tu głębokości · zamiast {selected}</translation>
    </message>
    <message>
        <source>No speed of the range bears {depth} mm: at most {limit} mm</source>
        <translation>Żadna prędkość z zakresu nie wytrzymuje {depth} mm: najwyżej {limit} mm</translation>
    </message>
    <message>
        <source>At {depth} mm with a margin of {margin} mm · {selected} is stable too</source>
        <translation>Przy {depth} mm z zapasem {margin} mm · {selected} też jest stabilna</translation>
    </message>
    <message>
        <source>At {depth} mm with a margin of {margin} mm · at {selected} no deeper than {largest} mm</source>
        <translation>Przy {depth} mm z zapasem {margin} mm · przy {selected} nie głębiej niż {largest} mm</translation>
    </message>
    <message>
        <source>By the rule of the papers, which knows no depth: {speed:0} 1/min</source>
        <translation>Według reguły z artykułów, która nie zna głębokości: {speed:0} 1/min</translation>
    </message>
    <message>
        <source>Still needed: {names}.</source>
        <translation>Brakuje jeszcze: {names}.</translation>
    </message>
    <message>
        <source>Only one of these can be given: {names}.</source>
        <translation>Można podać tylko jedno z tych: {names}.</translation>
    </message>
    <message>
        <source>Optional stops</source>
        <translation>Zatrzymania opcjonalne</translation>
    </message>
    <message>
        <source>A stop (M1) before each further tool, where the control&apos;s post knows one.</source>
        <translation>Zatrzymanie (M1) przed każdym dalszym narzędziem, jeśli postprocesor sterowania je zna.</translation>
    </message>
    <message>
        <source>State the work offset</source>
        <translation>Podanie przesunięcia zera</translation>
    </message>
    <message>
        <source>G54 at the start, where the control&apos;s post knows it.</source>
        <translation>G54 na początku, jeśli postprocesor sterowania je zna.</translation>
    </message>
    <message>
        <source>stop optionally</source>
        <translation>zatrzymać opcjonalnie</translation>
    </message>
    <message>
        <source>state the work offset</source>
        <translation>podać przesunięcia zera</translation>
    </message>
    <message>
        <source>Stops</source>
        <translation>Zatrzymania</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Zatrzymanie</translation>
    </message>
    <message>
        <source>What is done there</source>
        <translation>Co się wtedy robi</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>zatrzymanie</translation>
    </message>
    <message>
        <source>optional stop</source>
        <translation>zatrzymanie opcjonalne</translation>
    </message>
    <message>
        <source>clockwise (M3)</source>
        <translation>w prawo (M3)</translation>
    </message>
    <message>
        <source>anticlockwise (M4)</source>
        <translation>w lewo (M4)</translation>
    </message>
    <message>
        <source>Call in the program</source>
        <translation>Wywołanie w programie</translation>
    </message>
    <message>
        <source>Width, diameter</source>
        <translation>Szerokość, średnica</translation>
    </message>
    <message>
        <source>Cuts</source>
        <translation>Skrawa</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr</translation>
    </message>
    <message>
        <source>Largest feed, lead</source>
        <translation>Największy posuw, skok</translation>
    </message>
    <message>
        <source>Part and stock</source>
        <translation>Część i półfabrykat</translation>
    </message>
    <message>
        <source>Bar diameter</source>
        <translation>Średnica pręta</translation>
    </message>
    <message>
        <source>Bar length</source>
        <translation>Długość pręta</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>Faced off</source>
        <translation>Naddatek na czole</translation>
    </message>
    <message>
        <source>End that is turned</source>
        <translation>Toczony koniec</translation>
    </message>
    <message>
        <source>the other end: the work is turned round</source>
        <translation>drugi koniec: przedmiot jest odwrócony</translation>
    </message>
    <message>
        <source>the free end of the drawing</source>
        <translation>wolny koniec z rysunku</translation>
    </message>
    <message>
        <source>Zero point Z0</source>
        <translation>Punkt zerowy Z0</translation>
    </message>
    <message>
        <source>Chuck face at Z</source>
        <translation>Czoło uchwytu na Z</translation>
    </message>
    <message>
        <source>Stands out of the chuck before facing</source>
        <translation>Wysunięcie z uchwytu przed planowaniem</translation>
    </message>
    <message>
        <source>Diameter of the jaws</source>
        <translation>Średnica szczęk</translation>
    </message>
    <message>
        <source>Clamped at least</source>
        <translation>Zamocowane co najmniej</translation>
    </message>
    <message>
        <source>Tailstock, centre hole up to</source>
        <translation>Konik, nakiełek do średnicy</translation>
    </message>
    <message>
        <source>Cut off at Z</source>
        <translation>Odcięcie na Z</translation>
    </message>
    <message>
        <source>Speed limit of the spindle</source>
        <translation>Granica prędkości wrzeciona</translation>
    </message>
    <message>
        <source>Speed limit of the spindle (assumed)</source>
        <translation>Granica prędkości wrzeciona (przyjęta)</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>nie zapisany</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>Wiersze</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Przedmiot</translation>
    </message>
    <message>
        <source>What is left</source>
        <translation>Co zostaje</translation>
    </message>
    <message>
        <source>Nothing stays on the drawing.</source>
        <translation>Nic nie zostaje na rysunku.</translation>
    </message>
    <message>
        <source>This block is in a file of its own, and a correction changes the program alone. Put it into the program that calls it.</source>
        <translation>Ten blok jest w osobnym pliku, a korekta zmienia tylko sam program. Umieść go w programie, który go wywołuje.</translation>
    </message>
    <message>
        <source>The folder of subprograms holds {found} {unit}; at most {most} are looked at.</source>
        <translation>Katalog podprogramów zawiera {found} {unit}; przeglądanych jest najwyżej {most}.</translation>
    </message>
    <message>
        <source>Nose radius compensation without a known radius, up to line {last}: the programmed contour is shown.</source>
        <translation>Kompensacja promienia naroża bez znanego promienia, aż do wiersza {last}: pokazano zaprogramowany kontur.</translation>
    </message>
    <message>
        <source>The cycle starts at a radius of {start_mm:4} mm, within its contour, which reaches {reach_mm:4} mm: its rapid moves lead through the work.</source>
        <translation>Cykl zaczyna się na promieniu {start_mm:4} mm, wewnątrz swojego konturu, który sięga {reach_mm:4} mm: jego ruchy szybkie prowadzą przez materiał.</translation>
    </message>
    <message>
        <source>Lines {first_line} to {last_line} of this answer are lines 1 to {lines} of {path}.</source>
        <translation>Wiersze od {first_line} do {last_line} w tej odpowiedzi to wiersze od 1 do {lines} pliku {path}.</translation>
    </message>
    <message>
        <source>off</source>
        <translation>wyłączone</translation>
    </message>
    <message>
        <source>its kind of machining is none of 1 to 12 and 201 to 212</source>
        <translation>jego rodzaj obróbki nie jest żadnym z 1 do 12 i 201 do 212</translation>
    </message>
    <message>
        <source>the name of its contour is missing</source>
        <translation>brakuje nazwy jego konturu</translation>
    </message>
    <message>
        <source>the feed in force</source>
        <translation>obowiązujący posuw</translation>
    </message>
    <message>
        <source>on radius</source>
        <translation>na promieniu</translation>
    </message>
    <message>
        <source>on, in roughing and in finishing</source>
        <translation>włączona, przy obróbce zgrubnej i wykańczającej</translation>
    </message>
    <message>
        <source>its kind of machining is none of 1 to 4</source>
        <translation>jego rodzaj obróbki nie jest żadnym z 1 do 4</translation>
    </message>
    <message>
        <source>it states no pitch, or two that differ</source>
        <translation>nie podaje skoku albo podaje dwa różne</translation>
    </message>
    <message>
        <source>the depth of the thread is missing</source>
        <translation>brakuje głębokości gwintu</translation>
    </message>
    <message>
        <source>its kind of machining is none of 1 to 8 and 11 to 18</source>
        <translation>jego rodzaj obróbki nie jest żadnym z 1 do 8 i 11 do 18</translation>
    </message>
    <message>
        <source>the width or the depth of the groove is missing</source>
        <translation>brakuje szerokości lub głębokości rowka</translation>
    </message>
    <message>
        <source>the blade is wider than the groove</source>
        <translation>ostrze jest szersze niż rowek</translation>
    </message>
    <message>
        <source>its words are those of another control (Mach3)</source>
        <translation>jego słowa należą do innego sterowania (Mach3)</translation>
    </message>
    <message>
        <source>the subroutine that Q names is not in the program before it</source>
        <translation>podprogramu wskazanego przez Q nie ma w programie przed tym cyklem</translation>
    </message>
    <message>
        <source>it needs absolute coordinates (G90)</source>
        <translation>wymaga współrzędnych absolutnych (G90)</translation>
    </message>
    <message>
        <source>nose radius compensation is on</source>
        <translation>kompensacja promienia naroża jest włączona</translation>
    </message>
    <message>
        <source>a folder that exists</source>
        <translation>istniejący katalog</translation>
    </message>
    <message>
        <source>files</source>
        <translation>plików</translation>
    </message>
    <message>
        <source>Folder of subprograms</source>
        <translation>Katalog podprogramów</translation>
    </message>
    <message>
        <source>Programs that are called and not in the file are looked for there, by their names.</source>
        <translation>Tam szukane są po nazwach programy, które są wywoływane, a nie ma ich w pliku.</translation>
    </message>
    <message>
        <source>shaft, {length} mm</source>
        <translation>wał, {length} mm</translation>
    </message>
    <message>
        <source>response of {shaft}</source>
        <translation>odpowiedź: {shaft}</translation>
    </message>
    <message>
        <source>Shaft (SHAFT.json)…</source>
        <translation>Wał (SHAFT.json)…</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Stock text…</source>
        <translation>Tekst półfabrykatu…</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Tekst (*.txt)</translation>
    </message>
    <message>
        <source>Receptance (CSV)…</source>
        <translation>Receptancja (CSV)…</translation>
    </message>
    <message>
        <source>Receptance (UFF)…</source>
        <translation>Receptancja (UFF)…</translation>
    </message>
    <message>
        <source>Universal file (*.uff)</source>
        <translation>Plik uniwersalny (*.uff)</translation>
    </message>
    <message>
        <source>spindle</source>
        <translation>wrzeciono</translation>
    </message>
    <message>
        <source>spindle of {file}</source>
        <translation>wrzeciono z {file}</translation>
    </message>
    <message>
        <source>Spindle (SPINDLE.json)…</source>
        <translation>Wrzeciono (SPINDLE.json)…</translation>
    </message>
    <message>
        <source>Magnitude over frequency (CSV)…</source>
        <translation>Moduł w funkcji częstotliwości (CSV)…</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lekcje</translation>
    </message>
    <message>
        <source>{name}, edited</source>
        <translation>{name}, zmieniony</translation>
    </message>
    <message>
        <source>Drawing (*.dxf)</source>
        <translation>Rysunek (*.dxf)</translation>
    </message>
    <message>
        <source>Solid (STEP)…</source>
        <translation>Bryła (STEP)…</translation>
    </message>
    <message>
        <source>Solid (*.step)</source>
        <translation>Bryła (*.step)</translation>
    </message>
    <message>
        <source>Drawing or contour (DXF)…</source>
        <translation>Rysunek albo kontur (DXF)…</translation>
    </message>
    <message>
        <source>FreeCAD macro…</source>
        <translation>Makro FreeCAD…</translation>
    </message>
    <message>
        <source>FreeCAD macro (*.FCMacro)</source>
        <translation>Makro FreeCAD (*.FCMacro)</translation>
    </message>
    <message>
        <source>SolidWorks macro…</source>
        <translation>Makro SolidWorks…</translation>
    </message>
    <message>
        <source>SolidWorks macro (*.bas)</source>
        <translation>Makro SolidWorks (*.bas)</translation>
    </message>
    <message>
        <source>Table of rows (CSV)…</source>
        <translation>Tabela wierszy (CSV)…</translation>
    </message>
    <message>
        <source>Drawing (SVG)…</source>
        <translation>Rysunek (SVG)…</translation>
    </message>
    <message>
        <source>Picture (*.svg)</source>
        <translation>Obraz (*.svg)</translation>
    </message>
    <message>
        <source>Local radius and axis along the length (CSV)…</source>
        <translation>Promień miejscowy i oś wzdłuż długości (CSV)…</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>cale</translation>
    </message>
    <message>
        <source>turns per inch</source>
        <translation>zwoje na cal</translation>
    </message>
    <message>
        <source>Changes of rows</source>
        <translation>Zmiany wierszy</translation>
    </message>
    <message>
        <source>Made by a person.</source>
        <translation>Wprowadzone przez człowieka.</translation>
    </message>
    <message>
        <source>Rows changed of</source>
        <translation>Zmiany dotyczą</translation>
    </message>
    <message>
        <source>The scan that the changes are of.</source>
        <translation>Skan, którego dotyczą zmiany.</translation>
    </message>
    <message>
        <source>Accepted sizes</source>
        <translation>Przyjęte wymiary</translation>
    </message>
    <message>
        <source>Meridian and residuals (CSV)…</source>
        <translation>Zarys osiowy i reszty (CSV)…</translation>
    </message>
    <message>
        <source>Meridian (SVG)…</source>
        <translation>Zarys osiowy (SVG)…</translation>
    </message>
    <message>
        <source>Residuals (SVG)…</source>
        <translation>Reszty (SVG)…</translation>
    </message>
    <message>
        <source>made, out of tolerance</source>
        <translation>wykonany, poza tolerancją</translation>
    </message>
    <message>
        <source>made, not decided</source>
        <translation>wykonany, nierozstrzygnięty</translation>
    </message>
    <message>
        <source>{step}: {state}</source>
        <translation>{step}: {state}</translation>
    </message>
    <message>
        <source>the contour returns along the axis of the cycle</source>
        <translation>kontur zawraca wzdłuż osi cyklu</translation>
    </message>
    <message>
        <source>two lines of the contour have the same direction</source>
        <translation>dwie proste konturu mają ten sam kierunek</translation>
    </message>
    <message>
        <source>The original: a point cloud or mesh; or its drawing: a STEP file or SHAFT.json (mm). A drawing adds the sizes row by row.</source>
        <translation>Oryginał: chmura punktów lub siatka; albo jego rysunek: plik STEP lub SHAFT.json (mm). Rysunek dodaje wymiary wiersz po wierszu.</translation>
    </message>
    <message>
        <source>The copy: a point cloud or mesh.</source>
        <translation>Kopia: chmura punktów lub siatka.</translation>
    </message>
    <message>
        <source>Deviations of all points (PLY)…</source>
        <translation>Odchyłki wszystkich punktów (PLY)…</translation>
    </message>
    <message>
        <source>Point cloud (*.ply)</source>
        <translation>Chmura punktów (*.ply)</translation>
    </message>
    <message>
        <source>this speed {speed}</source>
        <translation>ta prędkość {speed}</translation>
    </message>
    <message>
        <source>The rule of the papers, which knows no depth, gives {speed_rpm} 1/min for z = {z_start_mm} … {z_end_mm} mm: {depth_mm:3} mm chatter there, up to {stable_depth_mm:3} mm are stable. The exact relation gives {exact_rpm:0} 1/min, stable up to {exact_depth_mm:3} mm.</source>
        <translation>Reguła z artykułów, która nie zna głębokości, daje {speed_rpm} 1/min dla z = {z_start_mm} … {z_end_mm} mm: przy {depth_mm:3} mm występują tam drgania samowzbudne, stabilne jest do {stable_depth_mm:3} mm. Zależność ścisła daje {exact_rpm:0} 1/min, stabilnie do {exact_depth_mm:3} mm.</translation>
    </message>
    <message>
        <source>The worn part: a point cloud or mesh.</source>
        <translation>Zużyta część: chmura punktów lub siatka.</translation>
    </message>
    <message>
        <source>What is handed on and written: the response, or its modal model.</source>
        <translation>Co jest przekazywane i zapisywane: charakterystyka albo jej model modalny.</translation>
    </message>
    <message>
        <source>{response}, modal model</source>
        <translation>{response}, model modalny</translation>
    </message>
    <message>
        <source>Response (CSV)…</source>
        <translation>Charakterystyka (CSV)…</translation>
    </message>
    <message>
        <source>Response (UFF 58)…</source>
        <translation>Charakterystyka (UFF 58)…</translation>
    </message>
    <message>
        <source>Modes (CSV)…</source>
        <translation>Postacie (CSV)…</translation>
    </message>
    <message>
        <source>by the rule {speed}</source>
        <translation>według reguły {speed}</translation>
    </message>
    <message>
        <source>Stable speeds</source>
        <translation>Prędkości stabilne</translation>
    </message>
    <message>
        <source>By the rule of the papers, which knows no depth</source>
        <translation>Według reguły z artykułów, która nie zna głębokości</translation>
    </message>
    <message>
        <source>Stable speeds of the range, the deepest first</source>
        <translation>Stabilne prędkości zakresu, od największej głębokości</translation>
    </message>
    <message>
        <source>Limit, in multiples of the least</source>
        <translation>Granica, w wielokrotnościach najmniejszej</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Granica</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Zapas</translation>
    </message>
    <message>
        <source>Stable at the depth</source>
        <translation>Stabilna przy tej głębokości</translation>
    </message>
    <message>
        <source>Whether it is stable depends on the depth of cut, which is not given</source>
        <translation>Czy jest stabilna, zależy od głębokości skrawania, której nie podano</translation>
    </message>
    <message>
        <source>How the light fell is not stated.</source>
        <translation>Nie podano, jak padało światło.</translation>
    </message>
    <message>
        <source>Regions kept</source>
        <translation>Zachowane obszary</translation>
    </message>
    <message>
        <source>Those of pictures that were taken away are not used.</source>
        <translation>Obszary usuniętych obrazów nie są używane.</translation>
    </message>
    <message>
        <source>Marks of {picture}</source>
        <translation>Ślady z {picture}</translation>
    </message>
    <message>
        <source>A photograph (PNG, JPEG, TIFF); several are compared, the first being before.</source>
        <translation>Zdjęcie (PNG, JPEG, TIFF); kilka jest porównywanych, pierwsze to stan przed.</translation>
    </message>
    <message>
        <source>Sound of the cut (WAV)…</source>
        <translation>Dźwięk skrawania (WAV)…</translation>
    </message>
    <message>
        <source>Sound (*.wav)</source>
        <translation>Dźwięk (*.wav)</translation>
    </message>
    <message>
        <source>Waveform (CSV)…</source>
        <translation>Przebieg (CSV)…</translation>
    </message>
    <message>
        <source>A probe record (CSV or L-Graph .dat/.par), or one for each section.</source>
        <translation>Zapis sond (CSV lub L-Graph .dat/.par), albo po jednym dla każdego przekroju.</translation>
    </message>
    <message>
        <source>Number of the section of the record; without it the one that deviates most.</source>
        <translation>Numer przekroju zapisu; bez niego ten o największej odchyłce.</translation>
    </message>
    <message>
        <source>A measured profile: x,y or angle,radius in a text table.</source>
        <translation>Zmierzony profil: x,y lub kąt,promień w tabeli tekstowej.</translation>
    </message>
    <message>
        <source>Judge a section of this probe record in place of a profile.</source>
        <translation>Oceń przekrój tego zapisu sond zamiast profilu.</translation>
    </message>
    <message>
        <source>For statistical process control (Q-DAS)…</source>
        <translation>Do statystycznego sterowania procesem (Q-DAS)…</translation>
    </message>
    <message>
        <source>Q-DAS (*.dfq)</source>
        <translation>Q-DAS (*.dfq)</translation>
    </message>
    <message>
        <source>Table of all sections (CSV)…</source>
        <translation>Tabela wszystkich przekrojów (CSV)…</translation>
    </message>
    <message>
        <source>Trajectories and images of all sections (CSV)…</source>
        <translation>Trajektorie i obrazy wszystkich przekrojów (CSV)…</translation>
    </message>
    <message>
        <source>The record has no section {section}: section {used}, which deviates most, is judged.</source>
        <translation>Zapis nie ma przekroju {section}: oceniany jest przekrój {used}, o największej odchyłce.</translation>
    </message>
    <message>
        <source>Verify installation</source>
        <translation>Sprawdzenie instalacji</translation>
    </message>
    <message>
        <source>{parameter} is {found}; usual is {minimum} to {maximum}. Is its unit the one of the name?</source>
        <translation>{parameter} wynosi {found}; zwykle jest to {minimum} do {maximum}. Czy jednostka jest tą z nazwy?</translation>
    </message>
    <message>
        <source>“{found}” names an angular frequency, and its unit is not stated. State --frequency-unit rad/s or hz.</source>
        <translation>„{found}” oznacza częstość kołową, a jej jednostki nie podano. Podaj --frequency-unit rad/s albo hz.</translation>
    </message>
    <message>
        <source>{path}: the unit {unit} is not known; the given unit {given} is used ({count} times, first at line {line}).</source>
        <translation>{path}: jednostka {unit} nie jest znana; użyto podanej jednostki {given} (razy: {count}, pierwszy w wierszu {line}).</translation>
    </message>
    <message>
        <source>{path}: as that of a driving point {response} has the wrong sign: at {frequency_hz} Hz its receptance has a positive imaginary part, and its phase falls with the frequency. Hammer or sensor was turned round, or a direction or the kind of motion is stated wrongly. Multiply it by -1; depths and speeds by it are wrong.</source>
        <translation>{path}: jako charakterystyka punktu wymuszenia {response} ma zły znak: przy {frequency_hz} Hz jej receptancja ma dodatnią część urojoną, a faza maleje z częstotliwością. Młotek lub czujnik był odwrócony albo błędnie podano kierunek lub rodzaj ruchu. Pomnóż ją przez -1; głębokości i prędkości z niej są błędne.</translation>
    </message>
    <message>
        <source>{path}: {response} is conjugated: its phase rises through the resonance at {frequency_hz} Hz, as under exp(-iωt). Change the sign of its imaginary part; depths and speeds by it are wrong.</source>
        <translation>{path}: {response} jest sprzężona: jej faza rośnie przez rezonans przy {frequency_hz} Hz, jak przy exp(-iωt). Zmień znak części urojonej; głębokości i prędkości z niej są błędne.</translation>
    </message>
    <message>
        <source>{path}: it holds {count} frequency responses; that of {used} (response/force) is used, not {others}. State --response to use another.</source>
        <translation>{path}: charakterystyk częstotliwościowych w pliku: {count}; użyto {used} (odpowiedź/siła), nie {others}. Aby użyć innej, podaj --response.</translation>
    </message>
    <message>
        <source>frequency with real,imag, with complex, or with magnitude or magnitude_db and phase (degrees) or phase_rad; coherence; skip for others</source>
        <translation>frequency z real,imag, z complex albo z magnitude lub magnitude_db i phase (stopnie) lub phase_rad; coherence; skip dla innych</translation>
    </message>
    <message>
        <source>a real vector f, freq, frequency, omega or one that ends with _hz</source>
        <translation>wektor rzeczywisty f, freq, frequency, omega lub o nazwie zakończonej na _hz</translation>
    </message>
    <message>
        <source>Unit of a frequency response that states none, or one that is not known. A known stated unit always rules.</source>
        <translation>Jednostka charakterystyki, która jej nie podaje albo podaje nieznaną. Znana podana jednostka ma zawsze pierwszeństwo.</translation>
    </message>
    <message>
        <source>Unit of the frequencies</source>
        <translation>Jednostka częstotliwości</translation>
    </message>
    <message>
        <source>Unit of frequencies that state none. A stated unit always rules.</source>
        <translation>Jednostka częstotliwości, które jej nie podają. Podana jednostka ma zawsze pierwszeństwo.</translation>
    </message>
    <message>
        <source>Which of several in the file: its number, or its nodes as 12/5 (response/force). Empty: of the driving points the most flexible, else the first.</source>
        <translation>Która z kilku w pliku: numer albo węzły jako 12/5 (odpowiedź/siła). Puste: najpodatniejsza z punktów wymuszenia, inaczej pierwsza.</translation>
    </message>
    <message>
        <source>Columns of the response</source>
        <translation>Kolumny charakterystyki</translation>
    </message>
    <message>
        <source>Of a table without headings: frequency,real,imag, or frequency,complex, or frequency,magnitude,phase (degrees; phase_rad; magnitude_db); coherence; skip.</source>
        <translation>Tabeli bez nagłówków: frequency,real,imag albo frequency,complex albo frequency,magnitude,phase (stopnie; phase_rad; magnitude_db); coherence; skip.</translation>
    </message>
    <message>
        <source>headings such as real_mm_N and imag_mm_N, magnitude_dB_re_1_mm_N, phase_deg</source>
        <translation>nagłówki takie jak real_mm_N i imag_mm_N, magnitude_dB_re_1_mm_N, phase_deg</translation>
    </message>
    <message>
        <source>headings such as frequency_hz, real_mm_N, imag_mm_N; without them state --frf-columns and --frf-unit</source>
        <translation>nagłówki takie jak frequency_hz, real_mm_N, imag_mm_N; bez nich podaj --frf-columns i --frf-unit</translation>
    </message>
    <message>
        <source>a unit of frequency such as Hz</source>
        <translation>jednostka częstotliwości, np. Hz</translation>
    </message>
    <message>
        <source>a unit such as m/s^2, g, mm or m/s, or that of the response stated</source>
        <translation>jednostka taka jak m/s^2, g, mm lub m/s albo podana jednostka charakterystyki</translation>
    </message>
    <message>
        <source>a unit of force such as N, kN or lbf, or that of the response stated</source>
        <translation>jednostka siły taka jak N, kN lub lbf albo podana jednostka charakterystyki</translation>
    </message>
    <message>
        <source>a unit that is not known</source>
        <translation>nieznana jednostka</translation>
    </message>
    <message>
        <source>The samples are not even in time: a step of {found_s} s among steps of {expected_s} s. Expected are steps that differ by at most 1 %.</source>
        <translation>Próbki nie są równomierne w czasie: krok {found_s} s wśród kroków {expected_s} s. Oczekiwano kroków różniących się najwyżej o 1 %.</translation>
    </message>
    <message>
        <source>The file holds no signals over time: found {found}, expected {expected}.</source>
        <translation>Plik nie zawiera sygnałów w czasie: znaleziono {found}, oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>{path}: {count} functions are no signals over time, the first at line {line}.</source>
        <translation>{path}: funkcji, które nie są sygnałami w czasie: {count}, pierwsza w wierszu {line}.</translation>
    </message>
    <message>
        <source>Time records</source>
        <translation>Zapisy w czasie</translation>
    </message>
    <message>
        <source>a table of signals over time: a force and a motion, with times or a rate</source>
        <translation>tabela sygnałów w czasie: siła i ruch, z czasami albo częstotliwością próbkowania</translation>
    </message>
    <message>
        <source>columns such as force_N, acc_m_s2</source>
        <translation>kolumny takie jak force_N, acc_m_s2</translation>
    </message>
    <message>
        <source>a unit of time: s or ms</source>
        <translation>jednostka czasu: s lub ms</translation>
    </message>
    <message>
        <source>data sets 58 of function 1</source>
        <translation>zbiory danych 58 funkcji 1</translation>
    </message>
    <message>
        <source>bytes of a chunk</source>
        <translation>bajty bloku danych</translation>
    </message>
    <message>
        <source>whole numbers of 16, 24 or 32 bits, or floating point of 32 bits</source>
        <translation>liczby całkowite 16-, 24- lub 32-bitowe albo zmiennoprzecinkowe 32-bitowe</translation>
    </message>
    <message>
        <source>a number of channels, 1 to 256</source>
        <translation>liczba kanałów, 1 do 256</translation>
    </message>
    <message>
        <source>a rate in samples a second</source>
        <translation>częstotliwość w próbkach na sekundę</translation>
    </message>
    <message>
        <source>a finite sample</source>
        <translation>skończona próbka</translation>
    </message>
    <message>
        <source>the chunk “fmt ” before the samples</source>
        <translation>blok danych „fmt ” przed próbkami</translation>
    </message>
    <message>
        <source>the chunk “data”</source>
        <translation>blok danych „data”</translation>
    </message>
    <message>
        <source>Accelerometer</source>
        <translation>Akcelerometr</translation>
    </message>
    <message>
        <source>g</source>
        <translation>g</translation>
    </message>
    <message>
        <source>Mass that moves with this point where it responds.</source>
        <translation>Masa, która porusza się z tym punktem, gdy on odpowiada.</translation>
    </message>
    <message>
        <source>Mass that moves with the point of this rod that responds.</source>
        <translation>Masa, która porusza się z odpowiadającym punktem tego pręta.</translation>
    </message>
    <message>
        <source>Averages</source>
        <translation>Uśrednienia</translation>
    </message>
    <message>
        <source>Taps averaged for each response; with the coherence they give its noise. 0: not known.</source>
        <translation>Uderzenia uśrednione w każdej charakterystyce; z koherencją dają jej szum. 0: nieznane.</translation>
    </message>
    <message>
        <source>Mass that moves with the point that responds.</source>
        <translation>Masa, która porusza się z odpowiadającym punktem.</translation>
    </message>
    <message>
        <source>The fit leaves {error_percent} % of the response, the scatter of its lines is {scatter_percent} %: the modal model does not describe it.</source>
        <translation>Dopasowanie zostawia {error_percent} % charakterystyki, rozrzut jej prążków wynosi {scatter_percent} %: model modalny jej nie opisuje.</translation>
    </message>
    <message>
        <source>1 to 8; 0: as many as the data tell.</source>
        <translation>1 do 8; 0: tyle, ile mówią dane.</translation>
    </message>
    <message>
        <source>As the nodes in the file tell</source>
        <translation>Jak mówią węzły w pliku</translation>
    </message>
    <message>
        <source>Yes</source>
        <translation>Tak</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nie</translation>
    </message>
    <message>
        <source>Driving point</source>
        <translation>Punkt wymuszenia</translation>
    </message>
    <message>
        <source>Force and response at one place in one direction: no stiffness is negative.</source>
        <translation>Siła i odpowiedź w jednym miejscu i kierunku: żadna sztywność nie jest ujemna.</translation>
    </message>
    <message>
        <source>Stability of the poles</source>
        <translation>Stabilność biegunów</translation>
    </message>
    <message>
        <source>Order of the fit, pairs of poles</source>
        <translation>Rząd dopasowania, pary biegunów</translation>
    </message>
    <message>
        <source>new</source>
        <translation>nowy</translation>
    </message>
    <message>
        <source>stable in frequency</source>
        <translation>stabilny w częstotliwości</translation>
    </message>
    <message>
        <source>stable in frequency and damping</source>
        <translation>stabilny w częstotliwości i tłumieniu</translation>
    </message>
    <message>
        <source>Stiffness of every response by mode, N/mm</source>
        <translation>Sztywność każdej charakterystyki według postaci, N/mm</translation>
    </message>
    <message>
        <source>Error, %</source>
        <translation>Błąd, %</translation>
    </message>
    <message>
        <source>Modes with viscous damping, G = Σ (1/k)/(1 - r² + 2iζr) - 1/(ω²M) + 1/K, r = f/f_n: linear fits of ascending order and matched filters give the starts, Gauss and Newton refine all parameters with weights from the noise of the lines, or from the errors of the fit where it is not known. A mode without which the fit is no worse than noise explains is left out. Uncertainties are standard uncertainties from the covariance.</source>
        <translation>Postacie z tłumieniem lepkim, G = Σ (1/k)/(1 - r² + 2iζr) - 1/(ω²M) + 1/K, r = f/f_n: starty dają dopasowania liniowe rosnącego rzędu i filtry dopasowane, a metoda Gaussa i Newtona poprawia wszystkie parametry z wagami z szumu prążków albo, gdy nie jest znany, z błędów dopasowania. Postać, bez której dopasowanie nie jest gorsze, niż tłumaczy szum, jest pomijana. Niepewności są niepewnościami standardowymi z kowariancji.</translation>
    </message>
    <message>
        <source>At {lines} of {all} frequencies the spindle found would give power away, by more than its uncertainty.</source>
        <translation>Przy {lines} z {all} częstotliwości znalezione wrzeciono oddawałoby moc, o więcej niż jego niepewność.</translation>
    </message>
    <message>
        <source>{path}: at {lines} of {all} frequencies, the first {frequency_hz} Hz, the receptance H of the spindle has a positive imaginary part: it would give power away.</source>
        <translation>{path}: przy {lines} z {all} częstotliwości, pierwsza {frequency_hz} Hz, receptancja H wrzeciona ma dodatnią część urojoną: oddawałoby ono moc.</translation>
    </message>
    <message>
        <source>The spindle found leaves {percent:1} % of the responses unexplained, more than {limit} % and more than their noise ({expected:1} %).</source>
        <translation>Znalezione wrzeciono nie wyjaśnia {percent:1} % charakterystyk, więcej niż {limit} % i więcej niż ich szum ({expected:1} %).</translation>
    </message>
    <message>
        <source>Rod {rod}: the response {respond}/{excite} fits with its sign turned: residual {before_percent:1} → {after_percent:1} %. It is used as measured.</source>
        <translation>Pręt {rod}: charakterystyka {respond}/{excite} pasuje z odwróconym znakiem: reszta {before_percent:1} → {after_percent:1} %. Użyto jej tak, jak zmierzono.</translation>
    </message>
    <message>
        <source>Rod {rod}: the responses fit with the points {first} and {second} swapped: residual {before_percent:1} → {after_percent:1} %. They are used as stated.</source>
        <translation>Pręt {rod}: charakterystyki pasują po zamianie punktów {first} i {second}: reszta {before_percent:1} → {after_percent:1} %. Użyto ich tak, jak podano.</translation>
    </message>
    <message>
        <source>Rod {rod}: the responses fit with the point {node} at {fitted_mm:1} mm from the chuck in place of {stated_mm:1} mm: residual {before_percent:1} → {after_percent:1} %. It is used as stated.</source>
        <translation>Pręt {rod}: charakterystyki pasują z punktem {node} w odległości {fitted_mm:1} mm od uchwytu zamiast {stated_mm:1} mm: reszta {before_percent:1} → {after_percent:1} %. Użyto go tak, jak podano.</translation>
    </message>
    <message>
        <source>Rod {rod}: the responses fit with {fitted_mm:1} mm of it outside the chuck in place of {stated_mm:1} mm: residual {before_percent:1} → {after_percent:1} %. It is used as stated.</source>
        <translation>Pręt {rod}: charakterystyki pasują, gdy poza uchwytem jest {fitted_mm:1} mm pręta zamiast {stated_mm:1} mm: reszta {before_percent:1} → {after_percent:1} %. Użyto go tak, jak podano.</translation>
    </message>
    <message>
        <source>Rod {rod}: the response {respond}/{excite} contradicts the others: residual {before_percent:1} → {after_percent:1} % without it. It is used as measured.</source>
        <translation>Pręt {rod}: charakterystyka {respond}/{excite} przeczy pozostałym: reszta {before_percent:1} → {after_percent:1} % bez niej. Użyto jej tak, jak zmierzono.</translation>
    </message>
    <message>
        <source>Rod</source>
        <translation>Pręt</translation>
    </message>
    <message>
        <source>Shafts on springs against finite elements</source>
        <translation>Wały na sprężynach względem elementów skończonych</translation>
    </message>
    <message>
        <source>Against rotation; 0: none.</source>
        <translation>Przeciw obrotowi; 0: brak.</translation>
    </message>
    <message>
        <source>From the free end.</source>
        <translation>Od wolnego końca.</translation>
    </message>
    <message>
        <source>A centre at z 0: radial and tilt stiffness.</source>
        <translation>Kieł w z 0: sztywność promieniowa i kątowa.</translation>
    </message>
    <message>
        <source>Springs between the shaft and the ground: z and radial stiffness.</source>
        <translation>Sprężyny między wałem a podłożem: z i sztywność promieniowa.</translation>
    </message>
    <message>
        <source>all that are used</source>
        <translation>wszystkie używane</translation>
    </message>
    <message>
        <source>worst: rod {rod}, {respond}/{excite}</source>
        <translation>najgorsza: pręt {rod}, {respond}/{excite}</translation>
    </message>
    <message>
        <source>{respond}/{excite}, predicted</source>
        <translation>{respond}/{excite}, przewidziana</translation>
    </message>
    <message>
        <source>one range such as 100:1200</source>
        <translation>jeden zakres, np. 100:1200</translation>
    </message>
    <message>
        <source>double hit</source>
        <translation>podwójne uderzenie</translation>
    </message>
    <message>
        <source>force overloaded</source>
        <translation>przesterowana siła</translation>
    </message>
    <message>
        <source>response overloaded</source>
        <translation>przesterowana odpowiedź</translation>
    </message>
    <message>
        <source>too little energy</source>
        <translation>za mało energii</translation>
    </message>
    <message>
        <source>the record ends within the block</source>
        <translation>zapis kończy się w bloku</translation>
    </message>
    <message>
        <source>Finding hits</source>
        <translation>Szukanie uderzeń</translation>
    </message>
    <message>
        <source>Averaging spectra</source>
        <translation>Uśrednianie widm</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>próbki</translation>
    </message>
    <message>
        <source>samples a second</source>
        <translation>próbki na sekundę</translation>
    </message>
    <message>
        <source>seconds at the first sample</source>
        <translation>sekundy przy pierwszej próbce</translation>
    </message>
    <message>
        <source>the hammer</source>
        <translation>młotek</translation>
    </message>
    <message>
        <source>a force such as N, or a sensitivity such as 2.25 mV/N or 500 N</source>
        <translation>siła taka jak N albo czułość taka jak 2.25 mV/N lub 500 N</translation>
    </message>
    <message>
        <source>500 N</source>
        <translation>500 N</translation>
    </message>
    <message>
        <source>the sensor</source>
        <translation>czujnik</translation>
    </message>
    <message>
        <source>a motion such as m/s^2, g, mm/s or um, or a sensitivity such as 100 mV/g</source>
        <translation>ruch taki jak m/s^2, g, mm/s lub um albo czułość taka jak 100 mV/g</translation>
    </message>
    <message>
        <source>50 g</source>
        <translation>50 g</translation>
    </message>
    <message>
        <source>another channel than the hammer</source>
        <translation>inny kanał niż młotek</translation>
    </message>
    <message>
        <source>Hammer</source>
        <translation>Młotek</translation>
    </message>
    <message>
        <source>Column or channel of the force, by name or number. Empty: the one in N or named so.</source>
        <translation>Kolumna lub kanał siły, według nazwy albo numeru. Puste: ten w N albo tak nazwany.</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Czujnik</translation>
    </message>
    <message>
        <source>Column or channel of the motion, by name or number. Empty: the one in m/s², g, mm/s…</source>
        <translation>Kolumna lub kanał ruchu, według nazwy albo numeru. Puste: ten w m/s², g, mm/s…</translation>
    </message>
    <message>
        <source>Sensitivity of the hammer</source>
        <translation>Czułość młotka</translation>
    </message>
    <message>
        <source>Of a record in volts: 2.25 mV/N; or the force of one unit of the record: 500 N.</source>
        <translation>Zapisu w woltach: 2.25 mV/N; albo siła jednej jednostki zapisu: 500 N.</translation>
    </message>
    <message>
        <source>Sensitivity of the sensor</source>
        <translation>Czułość czujnika</translation>
    </message>
    <message>
        <source>Of a record in volts: 100 mV/g, 10 mV/(m/s^2); or the motion of one unit of the record: 50 g. Its unit tells what is measured.</source>
        <translation>Zapisu w woltach: 100 mV/g, 10 mV/(m/s^2); albo ruch jednej jednostki zapisu: 50 g. Jej jednostka mówi, co jest mierzone.</translation>
    </message>
    <message>
        <source>Full scale</source>
        <translation>Pełna skala</translation>
    </message>
    <message>
        <source>Voltage of the largest number of a WAV file.</source>
        <translation>Napięcie największej liczby pliku WAV.</translation>
    </message>
    <message>
        <source>Sampling rate</source>
        <translation>Częstotliwość próbkowania</translation>
    </message>
    <message>
        <source>Of a record without times.</source>
        <translation>Zapisu bez czasów.</translation>
    </message>
    <message>
        <source>Which channel is {meaning} cannot be told among {found}. State --{parameter}.</source>
        <translation>Nie wiadomo, który z kanałów {found} to {meaning}. Podaj --{parameter}.</translation>
    </message>
    <message>
        <source>The unit of {channel} is not known: found “{found}”, expected {expected}. State it in the file, or a sensitivity by --{parameter}.</source>
        <translation>Jednostka kanału {channel} nie jest znana: znaleziono „{found}”, oczekiwano {expected}. Podaj ją w pliku albo podaj czułość przez --{parameter}.</translation>
    </message>
    <message>
        <source>{channel} is stated in parts of full scale; a sensitivity in volts needs the voltage of full scale. State --full-scale-V, or the sensitivity of full scale such as {expected}.</source>
        <translation>{channel} jest podany w częściach pełnej skali; czułość w woltach wymaga napięcia pełnej skali. Podaj --full-scale-V albo czułość pełnej skali, np. {expected}.</translation>
    </message>
    <message>
        <source>Neither times nor a rate are stated. State --rate-hz.</source>
        <translation>Nie podano ani czasów, ani częstotliwości próbkowania. Podaj --rate-hz.</translation>
    </message>
    <message>
        <source>A sample of {channel} is missing; a spectrum needs all of them.</source>
        <translation>Brakuje próbki kanału {channel}; widmo wymaga wszystkich.</translation>
    </message>
    <message>
        <source>{channel} has {found} in place of {expected}: {quantity}. Records are averaged only when alike.</source>
        <translation>{channel} ma {found} zamiast {expected}: {quantity}. Uśrednia się tylko zapisy jednakowe.</translation>
    </message>
    <message>
        <source>No hit is in the record: the largest force is {largest_N} N, the level that triggers {level_N} N.</source>
        <translation>W zapisie nie ma uderzenia: największa siła to {largest_N} N, poziom wyzwalania {level_N} N.</translation>
    </message>
    <message>
        <source>A block of {samples} samples is too short for a spectrum; at least {minimum} are needed.</source>
        <translation>Blok o liczbie próbek {samples} jest za krótki na widmo; potrzeba co najmniej {minimum}.</translation>
    </message>
    <message>
        <source>None of {count} hits is usable; the first at {time_s} s: {reason}. --keep-rejected takes them all the same.</source>
        <translation>Żadne z uderzeń (liczba: {count}) nie jest użyteczne; pierwsze przy {time_s} s: {reason}. --keep-rejected bierze je mimo to.</translation>
    </message>
    <message>
        <source>No line is between {from_hz} and {to_hz} Hz; usable are {usable_from_hz} to {usable_to_hz} Hz.</source>
        <translation>Między {from_hz} a {to_hz} Hz nie ma prążka; użyteczne są od {usable_from_hz} do {usable_to_hz} Hz.</translation>
    </message>
    <message>
        <source>Hits left out: {count} of {of} ({reason}), at {times} s.</source>
        <translation>Pominięte uderzenia: {count} z {of} ({reason}), przy {times} s.</translation>
    </message>
    <message>
        <source>Hits that would be left out, kept as asked: {count} of {of} ({reason}), at {times} s.</source>
        <translation>Uderzenia, które byłyby pominięte, zachowane na żądanie: {count} z {of} ({reason}), przy {times} s.</translation>
    </message>
    <message>
        <source>One hit only: its noise cannot be judged, and the coherence is not known.</source>
        <translation>Tylko jedno uderzenie: jego szumu nie można ocenić, a koherencja nie jest znana.</translation>
    </message>
    <message>
        <source>The exponential window adds {window_decay_1_s:3} 1/s to the decay of every mode: at {frequency_hz:1} Hz, {added_percent:3} % to the damping ratio, and the peak is lower by as much. Limits by it are too high.</source>
        <translation>Okno wykładnicze dodaje {window_decay_1_s:3} 1/s do zaniku każdej postaci: przy {frequency_hz:1} Hz {added_percent:3} % do stopnia tłumienia, a szczyt jest o tyle niższy. Granice z niego są za wysokie.</translation>
    </message>
    <message>
        <source>At the end of the block the response is still {percent:1} % of its peak: peaks are smeared. Take a longer block, or --window force_exponential.</source>
        <translation>Na końcu bloku odpowiedź ma jeszcze {percent:1} % swojego szczytu: szczyty są rozmyte. Weź dłuższy blok albo --window force_exponential.</translation>
    </message>
    <message>
        <source>The force is {drop_dB} dB below its maximum at {usable_to_hz:1} Hz; lines above are left out: {lines}.</source>
        <translation>Siła jest o {drop_dB} dB poniżej maksimum przy {usable_to_hz:1} Hz; pominięte prążki powyżej: {lines}.</translation>
    </message>
    <message>
        <source>Below {usable_from_hz:1} Hz the coherence is under {limit:1}; lines left out: {lines}.</source>
        <translation>Poniżej {usable_from_hz:1} Hz koherencja jest mniejsza niż {limit:1}; pominięte prążki: {lines}.</translation>
    </message>
    <message>
        <source>The pulses of the force are negative. If the hammer pushes in the positive direction of the sensor, turn the sign by a negative sensitivity.</source>
        <translation>Impulsy siły są ujemne. Jeżeli młotek uderza w dodatnim kierunku czujnika, odwróć znak ujemną czułością.</translation>
    </message>
    <message>
        <source>{path}: {channel} is stated in {unit}; the given sensitivity {given} is not used.</source>
        <translation>{path}: {channel} jest podany w {unit}; podanej czułości {given} nie użyto.</translation>
    </message>
    <message>
        <source>{path}: the file states {rate_hz} samples a second; the given rate {given_hz} is not used.</source>
        <translation>{path}: plik podaje {rate_hz} próbek na sekundę; podanej częstotliwości {given_hz} nie użyto.</translation>
    </message>
    <message>
        <source>H1: noise of the sensor averages out</source>
        <translation>H1: szum czujnika się uśrednia</translation>
    </message>
    <message>
        <source>H2: noise of the hammer averages out</source>
        <translation>H2: szum młotka się uśrednia</translation>
    </message>
    <message>
        <source>Estimator</source>
        <translation>Estymator</translation>
    </message>
    <message>
        <source>How the spectra of the hits are averaged.</source>
        <translation>Jak uśrednia się widma uderzeń.</translation>
    </message>
    <message>
        <source>force and exponential</source>
        <translation>siła i wykładnicze</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Okno</translation>
    </message>
    <message>
        <source>Force window and exponential window; the decay that the latter adds is stated.</source>
        <translation>Okno siły i okno wykładnicze; zanik, który dodaje to drugie, jest podany.</translation>
    </message>
    <message>
        <source>Time of the exponential window</source>
        <translation>Czas okna wykładniczego</translation>
    </message>
    <message>
        <source>In which it falls to 1/e. By default a third of the block.</source>
        <translation>W którym maleje do 1/e. Domyślnie jedna trzecia bloku.</translation>
    </message>
    <message>
        <source>Force window</source>
        <translation>Okno siły</translation>
    </message>
    <message>
        <source>From the trigger on. By default twice the pulse.</source>
        <translation>Od wyzwolenia. Domyślnie dwukrotność impulsu.</translation>
    </message>
    <message>
        <source>Length of the signals of a hit; its inverse is the distance of the lines. By default as long as the distance of the hits allows, at most 2 s.</source>
        <translation>Długość sygnałów jednego uderzenia; jej odwrotność to odstęp prążków. Domyślnie tyle, na ile pozwala odstęp uderzeń, najwyżej 2 s.</translation>
    </message>
    <message>
        <source>Whose lines are handed on. By default all usable ones.</source>
        <translation>Którego prążki są przekazywane. Domyślnie wszystkie użyteczne.</translation>
    </message>
    <message>
        <source>Trigger level</source>
        <translation>Poziom wyzwalania</translation>
    </message>
    <message>
        <source>Of the largest force of a record.</source>
        <translation>Największej siły zapisu.</translation>
    </message>
    <message>
        <source>Pre-trigger</source>
        <translation>Czas przed wyzwoleniem</translation>
    </message>
    <message>
        <source>Of a block in front of its hit. By default 2 % of the block.</source>
        <translation>Bloku przed jego uderzeniem. Domyślnie 2 % bloku.</translation>
    </message>
    <message>
        <source>Double hit</source>
        <translation>Podwójne uderzenie</translation>
    </message>
    <message>
        <source>A later pulse of more than this, of the peak, makes a hit a double one.</source>
        <translation>Późniejszy impuls większy niż tyle, szczytu, czyni uderzenie podwójnym.</translation>
    </message>
    <message>
        <source>Fall of the force</source>
        <translation>Spadek siły</translation>
    </message>
    <message>
        <source>Of its spectrum below the maximum, which ends the usable range.</source>
        <translation>Jej widma poniżej maksimum, który kończy użyteczny zakres.</translation>
    </message>
    <message>
        <source>dB</source>
        <translation>dB</translation>
    </message>
    <message>
        <source>Keep rejected hits</source>
        <translation>Zachowaj odrzucone uderzenia</translation>
    </message>
    <message>
        <source>Averages double, overloaded and weak hits as well.</source>
        <translation>Uśrednia także uderzenia podwójne, przesterowane i słabe.</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <source>mm/s²</source>
        <translation>mm/s²</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Prędkość</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>Przyspieszenie</translation>
    </message>
    <message>
        <source>hit used</source>
        <translation>uderzenie użyte</translation>
    </message>
    <message>
        <source>hit left out</source>
        <translation>uderzenie pominięte</translation>
    </message>
    <message>
        <source>window</source>
        <translation>okno</translation>
    </message>
    <message>
        <source>records one behind another</source>
        <translation>zapisy jeden za drugim</translation>
    </message>
    <message>
        <source>Force of the hammer</source>
        <translation>Siła młotka</translation>
    </message>
    <message>
        <source>{number}</source>
        <translation>{number}</translation>
    </message>
    <message>
        <source>{number}: {reason}</source>
        <translation>{number}: {reason}</translation>
    </message>
    <message>
        <source>Motion of the sensor</source>
        <translation>Ruch czujnika</translation>
    </message>
    <message>
        <source>Spectrum of the force</source>
        <translation>Widmo siły</translation>
    </message>
    <message>
        <source>Force, of its maximum</source>
        <translation>Siła, jej maksimum</translation>
    </message>
    <message>
        <source>usable up to {frequency} Hz</source>
        <translation>użyteczne do {frequency} Hz</translation>
    </message>
    <message>
        <source>Lines and windows</source>
        <translation>Prążki i okna</translation>
    </message>
    <message>
        <source>Distance of the lines</source>
        <translation>Odstęp prążków</translation>
    </message>
    <message>
        <source>Usable from</source>
        <translation>Użyteczne od</translation>
    </message>
    <message>
        <source>Usable up to</source>
        <translation>Użyteczne do</translation>
    </message>
    <message>
        <source>Decay added by the window</source>
        <translation>Zanik dodany przez okno</translation>
    </message>
    <message>
        <source>1/s</source>
        <translation>1/s</translation>
    </message>
    <message>
        <source>Hit</source>
        <translation>Uderzenie</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Zapis</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Siła szczytowa</translation>
    </message>
    <message>
        <source>Second pulse</source>
        <translation>Drugi impuls</translation>
    </message>
    <message>
        <source>Its time</source>
        <translation>Jego czas</translation>
    </message>
    <message>
        <source>Used</source>
        <translation>Użyte</translation>
    </message>
    <message>
        <source>Response usable up to</source>
        <translation>Charakterystyka użyteczna do</translation>
    </message>
    <message>
        <source>From {from} Hz · hits used: {used} of {hits} · a line every {resolution} Hz</source>
        <translation>Od {from} Hz · użyte uderzenia: {used} z {hits} · prążek co {resolution} Hz</translation>
    </message>
    <message>
        <source>From {from} Hz · hits used: {used} of {hits} · a line every {resolution} Hz · mean coherence {coherence}</source>
        <translation>Od {from} Hz · użyte uderzenia: {used} z {hits} · prążek co {resolution} Hz · średnia koherencja {coherence}</translation>
    </message>
    <message>
        <source>Hit at {time} s left out: {reason}</source>
        <translation>Uderzenie przy {time} s pominięte: {reason}</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Uderzenia</translation>
    </message>
    <message>
        <source>Impact test</source>
        <translation>Próba udarowa</translation>
    </message>
    <message>
        <source>Spectra of force F and motion X, averaged over the hits: H1 = Σ X F* / Σ F F*, H2 = Σ X X* / Σ F X*, coherence |Σ X F*|² / (Σ F F* · Σ X X*). An exponential window moves the response from iω to iω + σ; velocity and acceleration become a displacement by division by that and its square.</source>
        <translation>Widma siły F i ruchu X, uśrednione po uderzeniach: H1 = Σ X F* / Σ F F*, H2 = Σ X X* / Σ F X*, koherencja |Σ X F*|² / (Σ F F* · Σ X X*). Okno wykładnicze przesuwa charakterystykę z iω do iω + σ; prędkość i przyspieszenie stają się przemieszczeniem po podzieleniu przez tę wielkość i jej kwadrat.</translation>
    </message>
    <message>
        <source>All responses of the file</source>
        <translation>Wszystkie charakterystyki pliku</translation>
    </message>
    <message>
        <source>Fitted together: common frequencies and damping, own stiffnesses.</source>
        <translation>Dopasowane razem: wspólne częstotliwości i tłumienie, własne sztywności.</translation>
    </message>
    <message>
        <source>nodes of response and force such as 12/5 or 12x/5x</source>
        <translation>węzły odpowiedzi i siły, np. 12/5 lub 12x/5x</translation>
    </message>
    <message>
        <source>another quantity of the sensor, as displacement 0, velocity 1, acceleration 2</source>
        <translation>inna wielkość czujnika: przemieszczenie 0, prędkość 1, przyspieszenie 2</translation>
    </message>
    <message>
        <source>Nodes</source>
        <translation>Węzły</translation>
    </message>
    <message>
        <source>Of response and force, as 12/5 or 12x/5x, for a universal file. Empty: those of the record.</source>
        <translation>Odpowiedzi i siły, jako 12/5 lub 12x/5x, dla pliku uniwersalnego. Puste: te z zapisu.</translation>
    </message>
    <message>
        <source>Tap test</source>
        <translation>Próba udarowa</translation>
    </message>
    <message>
        <source>Time record</source>
        <translation>Zapis w czasie</translation>
    </message>
    <message>
        <source>Force and motion over time (CSV, UFF or WAV), or one record for each hit.</source>
        <translation>Siła i ruch w czasie (CSV, UFF lub WAV) albo po jednym zapisie na uderzenie.</translation>
    </message>
    <message>
        <source>From {from_hz} to {to_hz} Hz the response has {found} lines; at least 4 are needed. It runs from {first_hz} to {last_hz} Hz.</source>
        <translation>Od {from_hz} do {to_hz} Hz liczba prążków charakterystyki to {found}; potrzeba co najmniej 4. Sięga ona od {first_hz} do {last_hz} Hz.</translation>
    </message>
    <message>
        <source>{path}: {count} lines hold no more than the noise of the sensor and are left out; used is {from_hz} to {to_hz} Hz. --range-hz states another range.</source>
        <translation>{path}: prążki, które nie zawierają nic ponad szum czujnika i są pominięte: {count}; użyto od {from_hz} do {to_hz} Hz. --range-hz podaje inny zakres.</translation>
    </message>
    <message>
        <source>{path}: nowhere does the response stand out of the noise of its lines.</source>
        <translation>{path}: charakterystyka nigdzie nie wystaje ponad szum swoich prążków.</translation>
    </message>
    <message>
        <source>one range of frequencies</source>
        <translation>jeden zakres częstotliwości</translation>
    </message>
    <message>
        <source>Uncertainty of the damping</source>
        <translation>Niepewność tłumienia</translation>
    </message>
    <message>
        <source>One standard deviation of each damping ratio; of modes that are stated or fitted.</source>
        <translation>Jedno odchylenie standardowe każdego stopnia tłumienia; postaci podanych albo dopasowanych.</translation>
    </message>
    <message>
        <source>a response by its modes: stated ones, or the fitted model</source>
        <translation>charakterystyka przez postacie: podane albo dopasowany model</translation>
    </message>
    <message>
        <source>Error of the modes at this frequency</source>
        <translation>Błąd postaci przy tej częstotliwości</translation>
    </message>
    <message>
        <source>Error of the modes over all lines</source>
        <translation>Błąd postaci na wszystkich prążkach</translation>
    </message>
    <message>
        <source>A simulation needs modes, and none could be found in the frequency response. State them with --mode.</source>
        <translation>Symulacja wymaga postaci, a w charakterystyce częstotliwościowej żadnej nie znaleziono. Podaj je przez --mode.</translation>
    </message>
    <message>
        <source>The least real part, at {frequency_hz} Hz, hardly stands out of the noise of its line ({noise_percent} % of it): the least depth may be that of the noise. State the range that was excited with --range-hz.</source>
        <translation>Najmniejsza część rzeczywista, przy {frequency_hz} Hz, ledwie wystaje ponad szum swojego prążka ({noise_percent} % z niej): najmniejsza głębokość może wynikać z szumu. Podaj wzbudzony zakres przez --range-hz.</translation>
    </message>
    <message>
        <source>The resonance that limits the depth, at {frequency_hz} Hz, is seen by {lines} lines within its half-power band: the least depth may be wrong by 15 %. Measure longer for a finer resolution, or use the fitted model.</source>
        <translation>Rezonans, który ogranicza głębokość, przy {frequency_hz} Hz, widać w prążkach w jego paśmie połowy mocy w liczbie {lines}: najmniejsza głębokość może być błędna o 15 %. Mierz dłużej, aby zmniejszyć krok częstotliwości, albo użyj dopasowanego modelu.</translation>
    </message>
    <message>
        <source>So many lobes reach these speeds that {count} of them are not listed: those farthest from the foot of the lobes, and the slowest. The limit is that of all.</source>
        <translation>Tych prędkości sięga tyle worków, że nie wymieniono ich w liczbie {count}: najdalszych od podstawy worków i najwolniejszych. Granica jest granicą wszystkich.</translation>
    </message>
    <message>
        <source>Modes fitted to the frequency response, which the simulation rests on: {count}; what they leave of it together with what lies outside its lines is {error_percent} %.</source>
        <translation>Postacie dopasowane do charakterystyki częstotliwościowej, na których opiera się symulacja: {count}; zostaje z niej razem z tym, co leży poza jej prążkami, {error_percent} %.</translation>
    </message>
    <message>
        <source>Modes of the computed response, which the simulation rests on: {count}; what they leave of it together with the compliance beyond its lines is {error_percent} %.</source>
        <translation>Postacie obliczonej charakterystyki, na których opiera się symulacja: {count}; zostaje z niej razem z podatnością poza jej prążkami {error_percent} %.</translation>
    </message>
    <message>
        <source>At {frequency_hz} Hz, where the cut vibrates, the modes that are simulated leave {error_percent} % of the frequency response, more than {limit_percent} %: the verdict is undecided.</source>
        <translation>Przy {frequency_hz} Hz, gdzie drga skrawanie, symulowane postacie zostawiają {error_percent} % charakterystyki częstotliwościowej, więcej niż {limit_percent} %: orzeczenie jest nierozstrzygnięte.</translation>
    </message>
    <message>
        <source>The vibration of the simulated cut, {frequency_hz} Hz, lies outside the lines of the frequency response, {from_hz} to {to_hz} Hz: the verdict is undecided.</source>
        <translation>Drgania symulowanego skrawania, {frequency_hz} Hz, leżą poza prążkami charakterystyki częstotliwościowej, {from_hz} do {to_hz} Hz: orzeczenie jest nierozstrzygnięte.</translation>
    </message>
    <message>
        <source>Noise of its line</source>
        <translation>Szum jej prążka</translation>
    </message>
    <message>
        <source>Limits against roots of the delay equation</source>
        <translation>Granice względem pierwiastków równania z opóźnieniem</translation>
    </message>
    <message>
        <source>Limits of impact tests with the sensor&apos;s noise</source>
        <translation>Granice prób udarowych z szumem czujnika</translation>
    </message>
    <message>
        <source>Frequencies used</source>
        <translation>Używane częstotliwości</translation>
    </message>
    <message>
        <source>Of a measured response, 100:700. Default: the lines that stand out of their noise.</source>
        <translation>Zmierzonej charakterystyki, 100:700. Domyślnie: prążki, które wystają ponad swój szum.</translation>
    </message>
    <message>
        <source>The lines</source>
        <translation>Prążki</translation>
    </message>
    <message>
        <source>The fitted modes</source>
        <translation>Dopasowane postacie</translation>
    </message>
    <message>
        <source>Used of a measurement</source>
        <translation>Z pomiaru</translation>
    </message>
    <message>
        <source>The lines as measured, or the modes fitted to them, with their uncertainties.</source>
        <translation>Prążki tak, jak zmierzono, albo dopasowane do nich postacie, z ich niepewnościami.</translation>
    </message>
    <message>
        <source>{name} says nothing here: it belongs to {names}.</source>
        <translation>{name} nic tu nie mówi: należy do {names}.</translation>
    </message>
    <message>
        <source>all</source>
        <translation>wszystkie</translation>
    </message>
    <message>
        <source>form</source>
        <translation>kształt</translation>
    </message>
    <message>
        <source>registration</source>
        <translation>dopasowanie</translation>
    </message>
    <message>
        <source>dynamics</source>
        <translation>dynamika</translation>
    </message>
    <message>
        <source>deflection</source>
        <translation>ugięcie</translation>
    </message>
    <message>
        <source>Which checks are run.</source>
        <translation>Które sprawdzenia są wykonywane.</translation>
    </message>
    <message>
        <source>Drop the record of a tap test here, hammer and sensor over time, or one for each hit.</source>
        <translation>Upuść tu zapis próby udarowej, młotek i czujnik w czasie, albo po jednym na uderzenie.</translation>
    </message>
    <message>
        <source>Real modes leave {real_percent} % of the response; modes whose residues have a phase are fitted, which leave {error_percent} %.</source>
        <translation>Postacie rzeczywiste zostawiają {real_percent} % charakterystyki; dopasowano postacie, których reszty mają fazę, te zostawiają {error_percent} %.</translation>
    </message>
    <message>
        <source>Response node</source>
        <translation>Węzeł odpowiedzi</translation>
    </message>
    <message>
        <source>Force node</source>
        <translation>Węzeł siły</translation>
    </message>
    <message>
        <source>χ² per degree</source>
        <translation>χ² na stopień</translation>
    </message>
    <message>
        <source>The slowest decay, {frequency_hz} Hz, is that of what lies outside the lines of the frequency response, {from_hz} to {to_hz} Hz, and is not known; within them vibrations decay faster than the growth stated.</source>
        <translation>Najwolniejsze zanikanie, {frequency_hz} Hz, pochodzi od tego, co leży poza prążkami charakterystyki, od {from_hz} do {to_hz} Hz, i nie jest znane; w ich obrębie drgania zanikają szybciej niż podany przyrost.</translation>
    </message>
    <message>
        <source>Mistakes of tap tests named</source>
        <translation>Nazwane błędy prób udarowych</translation>
    </message>
    <message>
        <source>NOT EXPLAINED, z {from}-{to}</source>
        <translation>NIEWYJAŚNIONE, z {from}-{to}</translation>
    </message>
    <message>
        <source>Unexplained structure ({structure}) from z {z_start_mm:1} to {z_end_mm:1} mm, {area_mm2:1} mm², up to {height_mm:3} mm, at {places} places around the axis: no row and no mark describes it.</source>
        <translation>Niewyjaśniona struktura ({structure}) od z {z_start_mm:1} do {z_end_mm:1} mm, {area_mm2:1} mm², do {height_mm:3} mm, w {places} miejscach wokół osi: nie opisuje jej żaden wiersz ani znak.</translation>
    </message>
    <message>
        <source>No points from z {z_start_mm:1} to {z_end_mm:1} mm, {area_mm2:1} mm², at {places} round places of a surface that is seen: no row and no mark explains it.</source>
        <translation>Brak punktów od z {z_start_mm:1} do {z_end_mm:1} mm, {area_mm2:1} mm², w {places} okrągłych miejscach widocznej powierzchni: nie wyjaśnia tego żaden wiersz ani znak.</translation>
    </message>
    <message>
        <source>Structure that no row explains was stated to be damage of the part: {count} stretches.</source>
        <translation>Strukturę, której nie wyjaśnia żaden wiersz, podano jako uszkodzenie części: odcinków {count}.</translation>
    </message>
    <message>
        <source>The noise of neighbouring points is correlated: the uncertainties are {factor:1} times those of independent points.</source>
        <translation>Szum sąsiednich punktów jest skorelowany: niepewności są {factor:1} razy większe niż dla punktów niezależnych.</translation>
    </message>
    <message>
        <source>Passes of the scanner differ by {difference_um:1} µm on the radius (χ² {chi2:1} per bin): every diameter may be off by twice that.</source>
        <translation>Przejścia skanera różnią się o {difference_um:1} µm na promieniu (χ² {chi2:1} na przedział): każda średnica może być błędna o dwa razy tyle.</translation>
    </message>
    <message>
        <source>At the shoulder near z {z_mm:2} mm rays hit and miss over all of half a millimetre: its place is that of the walls beside it.</source>
        <translation>Przy odsadzeniu koło z {z_mm:2} mm promienie trafiają i chybiają na całej szerokości pół milimetra: jego położenie wynika z sąsiednich ścianek.</translation>
    </message>
    <message>
        <source>The bins scatter more than their noise explains (χ² {chi2:1} per bin): the uncertainties are multiplied by its root.</source>
        <translation>Przedziały są rozrzucone bardziej, niż wyjaśnia to szum (χ² {chi2:1} na przedział): niepewności pomnożono przez pierwiastek.</translation>
    </message>
    <message>
        <source>Row {row}: the data do not determine its {size} (U {uncertainty_mm:1} mm); it is given without an uncertainty.</source>
        <translation>Wiersz {row}: dane nie wyznaczają wielkości „{size}” (U {uncertainty_mm:1} mm); podano ją bez niepewności.</translation>
    </message>
    <message>
        <source>Rows that are not round: {count}; row {row} has {lobes} lobes of {height_um:1} µm.</source>
        <translation>Wiersze nieokrągłe: {count}; wiersz {row} ma {lobes} łuki o wysokości {height_um:1} µm.</translation>
    </message>
    <message>
        <source>start</source>
        <translation>początek</translation>
    </message>
    <message>
        <source>end</source>
        <translation>koniec</translation>
    </message>
    <message>
        <source>start diameter</source>
        <translation>średnica początkowa</translation>
    </message>
    <message>
        <source>end diameter</source>
        <translation>średnica końcowa</translation>
    </message>
    <message>
        <source>no CAD, no program</source>
        <translation>bez CAD i programu</translation>
    </message>
    <message>
        <source>damage of the part</source>
        <translation>uszkodzenie części</translation>
    </message>
    <message>
        <source>Unexplained structure</source>
        <translation>Niewyjaśniona struktura</translation>
    </message>
    <message>
        <source>What no row and no mark explains. Damage: a person says that the part was made without it.</source>
        <translation>To, czego nie wyjaśnia żaden wiersz ani znak. Uszkodzenie: człowiek stwierdza, że część wykonano bez tego.</translation>
    </message>
    <message>
        <source>unexplained</source>
        <translation>niewyjaśnione</translation>
    </message>
    <message>
        <source>raised</source>
        <translation>wypukłe</translation>
    </message>
    <message>
        <source>sunken</source>
        <translation>wklęsłe</translation>
    </message>
    <message>
        <source>without points</source>
        <translation>bez punktów</translation>
    </message>
    <message>
        <source>Variance of a row&apos;s mean over that of independent points</source>
        <translation>Wariancja średniej wiersza względem punktów niezależnych</translation>
    </message>
    <message>
        <source>Structure that no row and no mark explains</source>
        <translation>Struktura, której nie wyjaśnia żaden wiersz ani znak</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Miejsca</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Kierunek</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Pole</translation>
    </message>
    <message>
        <source>mm²</source>
        <translation>mm²</translation>
    </message>
    <message>
        <source>Unexplained: {structure} · z {from_mm:1}-{to_mm:1} mm</source>
        <translation>Niewyjaśnione: {structure} · z {from_mm:1}-{to_mm:1} mm</translation>
    </message>
    <message>
        <source>Off the axis</source>
        <translation>Poza osią</translation>
    </message>
    <message>
        <source>Height of the lobes</source>
        <translation>Wysokość łuków</translation>
    </message>
    <message>
        <source>From z {z_start_mm:1} to {z_end_mm:1} mm the scan shows structure that the rows of the shaft do not describe.</source>
        <translation>Od z {z_start_mm:1} do {z_end_mm:1} mm skan pokazuje strukturę, której wiersze wału nie opisują.</translation>
    </message>
    <message>
        <source>Half of the difference between passes, on the radius</source>
        <translation>Połowa różnicy między przejściami, na promieniu</translation>
    </message>
    <message>
        <source>a bore is not seen over its whole length</source>
        <translation>otworu nie widać na całej jego długości</translation>
    </message>
    <message>
        <source>cut what is clearly not the part</source>
        <translation>odcinaj to, co wyraźnie nie jest częścią</translation>
    </message>
    <message>
        <source>A turntable, clamps and loose things in the scan: automatically cut off are a plane much larger than the part, a chuck&apos;s jaws or a centre at an end of it, clusters of points.</source>
        <translation>Stół obrotowy, zaciski i luźne elementy na skanie: automatycznie odcinane są płaszczyzna znacznie większa od części, szczęki uchwytu lub kieł na jej końcu oraz skupiska punktów.</translation>
    </message>
    <message>
        <source>Stretches along the recognised axis that are left out: z as in the table without them, from the first data at the free end, after things besides the part were cut off.</source>
        <translation>Odcinki wzdłuż rozpoznanej osi, które zostają pominięte: z jak w tabeli bez nich, od początku danych na wolnym końcu, po odcięciu tego, co nie jest częścią.</translation>
    </message>
    <message>
        <source>Row {row} is structure that was not understood: where it begins and ends is stated without uncertainty.</source>
        <translation>Wiersz {row} to struktura, której nie zrozumiano: jej początek i koniec podano bez niepewności.</translation>
    </message>
    <message>
        <source>Across flats</source>
        <translation>Rozwartość klucza</translation>
    </message>
    <message>
        <source>Through</source>
        <translation>Na wylot</translation>
    </message>
    <message>
        <source>Count</source>
        <translation>Liczba</translation>
    </message>
    <message>
        <source>Pitch circle ⌀</source>
        <translation>⌀ podziałowa</translation>
    </message>
    <message>
        <source>Offset from the axis</source>
        <translation>Przesunięcie od osi</translation>
    </message>
    <message>
        <source>U of its size</source>
        <translation>U jego wymiaru</translation>
    </message>
    <message>
        <source>Marks that no body of revolution shows, left out of the CAD file: {count} ({kinds}); its volume is that of the plain body. The drawing shows them.</source>
        <translation>Znaki, których bryła obrotowa nie pokazuje, pominięte w pliku CAD: {count} ({kinds}); jego objętość jest objętością samej bryły. Pokazuje je rysunek.</translation>
    </message>
    <message>
        <source>it is prismatic; planes along the axis bound it</source>
        <translation>jest graniasta; ograniczają ją płaszczyzny wzdłuż osi</translation>
    </message>
    <message>
        <source>part of its outside is eccentric, a cylinder beside the axis</source>
        <translation>część jej powierzchni zewnętrznej jest mimośrodowa, to walec obok osi</translation>
    </message>
    <message>
        <source>Such as ISO 2768-m; empty: as the input has them, else none.</source>
        <translation>Na przykład ISO 2768-m; puste: jak w danych, inaczej brak.</translation>
    </message>
    <message>
        <source>Surface texture</source>
        <translation>Struktura powierzchni</translation>
    </message>
    <message>
        <source>Note in the title block, such as Rz 16; empty: none.</source>
        <translation>Uwaga w tabliczce rysunkowej, na przykład Rz 16; puste: brak.</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>Autor</translation>
    </message>
    <message>
        <source>Empty: none.</source>
        <translation>Puste: brak.</translation>
    </message>
    <message>
        <source>Title block</source>
        <translation>Tabliczka</translation>
    </message>
    <message>
        <source>Suggested sizes that a person confirms, as row:quantity: 2:diameter_mm,5:leg_mm. They are put in place even beyond U.</source>
        <translation>Proponowane wymiary, które potwierdza człowiek, jako wiersz:wielkość: 2:diameter_mm,5:leg_mm. Są wstawiane także poza U.</translation>
    </message>
    <message>
        <source>through</source>
        <translation>na wylot</translation>
    </message>
    <message>
        <source>{depth} deep</source>
        <translation>głębokość {depth}</translation>
    </message>
    <message>
        <source>(length {length})</source>
        <translation>(długość {length})</translation>
    </message>
    <message>
        <source>{count}×{hole} on ⌀{circle}</source>
        <translation>{count}×{hole} na ⌀{circle}</translation>
    </message>
    <message>
        <source>AF </source>
        <translation>rozw. </translation>
    </message>
    <message>
        <source>spline {teeth}×{root}×{crest}</source>
        <translation>wielowypust {teeth}×{root}×{crest}</translation>
    </message>
    <message>
        <source>INCOMPLETE: the sheet is too small for the dimensions and sections</source>
        <translation>NIEKOMPLETNY: arkusz jest za mały na wymiary i przekroje</translation>
    </message>
    <message>
        <source>Mass without marks</source>
        <translation>Masa bez znaków</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Rzutowanie</translation>
    </message>
    <message>
        <source>The stated length of {length_mm:3} mm contradicts the data, which show {data_mm:3} ± {uncertainty_mm:3} mm.</source>
        <translation>Podana długość {length_mm:3} mm przeczy danym, które pokazują {data_mm:3} ± {uncertainty_mm:3} mm.</translation>
    </message>
    <message>
        <source>The {end} is a ball of {diameter_mm} mm with its centre on the axis: it was closed at the ball&apos;s pole. Within {unseen_diameter_mm} mm about the axis no points of it are seen: a small flat there would not be either.</source>
        <translation>Na końcu ({end}) jest kula o średnicy {diameter_mm} mm ze środkiem na osi: zamknięto go w biegunie kuli. W odległości do {unseen_diameter_mm} mm średnicy wokół osi nie widać jej punktów: nie byłoby tam widać także małego spłaszczenia.</translation>
    </message>
    <message>
        <source>Whether the part ends where the data do is not decided at the {end}: if so, from z {from_mm:3} to {to_mm:3} mm. The length is not known; state it to confirm the end.</source>
        <translation>Nie rozstrzygnięto, czy część kończy się tam, gdzie dane ({end}): jeśli tak, to od z {from_mm:3} do {to_mm:3} mm. Długość nie jest znana; podaj ją, aby potwierdzić koniec.</translation>
    </message>
    <message>
        <source>Suggested sizes that the measured ones do not agree with within U stay as measured: {count} ({sizes}). A person may confirm each.</source>
        <translation>Proponowane wymiary, z którymi zmierzone nie zgadzają się w granicach U, pozostają zmierzone: {count} ({sizes}). Każdy może potwierdzić człowiek.</translation>
    </message>
    <message>
        <source>lies from</source>
        <translation>leży od</translation>
    </message>
    <message>
        <source>, beyond U</source>
        <translation>, poza U</translation>
    </message>
    <message>
        <source>Lies between</source>
        <translation>Leży między</translation>
    </message>
    <message>
        <source>The shaft has a mark that is not turned: {mark}, z {z_start_mm:1} to {z_end_mm:1} mm. No solid and no program are made of its rows alone; the drawing shows it.</source>
        <translation>Wałek ma znak, który nie jest toczony: {mark}, z od {z_start_mm:1} do {z_end_mm:1} mm. Z samych wierszy nie powstaje bryła ani program; pokazuje go rysunek.</translation>
    </message>
    <message>
        <source>Of a shaft that was recovered from a scan.</source>
        <translation>Wałka odtworzonego ze skanu.</translation>
    </message>
    <message>
        <source>SHA-256 of the scan</source>
        <translation>SHA-256 skanu</translation>
    </message>
    <message>
        <source>Method of the recognition</source>
        <translation>Metoda rozpoznania</translation>
    </message>
    <message>
        <source>The file states no size of its pixels; give the scale by another option.</source>
        <translation>Plik nie podaje rozmiaru piksela; podaj skalę inną opcją.</translation>
    </message>
    <message>
        <source>{path}: the scale was taken from the file, {um_per_px} µm per pixel.</source>
        <translation>{path}: skalę wzięto z pliku, {um_per_px} µm na piksel.</translation>
    </message>
    <message>
        <source>{path}: marks of two feeds lie in the picture, {pitch} and {second_pitch} {unit} apart, in different parts of it. Chatter was not looked for; evaluate each part by itself with a region.</source>
        <translation>{path}: na zdjęciu leżą ślady dwóch posuwów, co {pitch} i co {second_pitch} {unit}, w różnych jego częściach. Drgań nie szukano; oceń każdą część osobno, podając obszar.</translation>
    </message>
    <message>
        <source>Scale from the file</source>
        <translation>Skala z pliku</translation>
    </message>
    <message>
        <source>The size of a pixel that the picture&apos;s file states, as microscopes write it.</source>
        <translation>Rozmiar piksela podany w pliku zdjęcia, tak jak zapisują go mikroskopy.</translation>
    </message>
    <message>
        <source>an end is not seen or undecided; state the length to confirm it (--length-mm)</source>
        <translation>końca nie widać albo jest nierozstrzygnięty; proszę podać długość, aby go potwierdzić (--length-mm)</translation>
    </message>
    <message>
        <source>blind, depth not known</source>
        <translation>nieprzelotowy, głębokość nieznana</translation>
    </message>
    <message>
        <source>corners </source>
        <translation>naroża </translation>
    </message>
    <message>
        <source>NOT EXPLAINED, z {z}</source>
        <translation>NIEWYJAŚNIONE, z {z}</translation>
    </message>
    <message>
        <source>{kind}, {width} wide, {depth} deep</source>
        <translation>{kind}, szerokość {width}, głębokość {depth}</translation>
    </message>
    <message>
        <source>italic: as measured; not a specification. ± U: k = 2; no ±: U is not known</source>
        <translation>kursywa: wartości zmierzone; nie są wymaganiem. ± U: k = 2; bez ±: U nieznane</translation>
    </message>
    <message>
        <source>The length of {length} mm was stated; an end is not seen.</source>
        <translation>Długość {length} mm podano; końca nie widać.</translation>
    </message>
    <message>
        <source>The drawing has this from z {from_mm:1} to {to_mm:1} mm, and it is not found in the copy: {kind}. Neither the surface nor the sizes of the rows judge it.</source>
        <translation>Rysunek ma to od z {from_mm:1} do {to_mm:1} mm, a na kopii tego nie znaleziono: {kind}. Nie ocenia tego ani powierzchnia, ani wymiary wierszy.</translation>
    </message>
    <message>
        <source>Marks of the drawing that the copy has too: {count}. Their sizes are not compared.</source>
        <translation>Elementy z rysunku, które ma też kopia: {count}. Ich wymiarów nie porównano.</translation>
    </message>
    <message>
        <source>Free end not decided: it lies from z {from_mm:3} to {to_mm:3} mm</source>
        <translation>Wolny koniec nierozstrzygnięty: leży od z {from_mm:3} do {to_mm:3} mm</translation>
    </message>
    <message>
        <source>Chuck end not decided: it lies from z {from_mm:3} to {to_mm:3} mm</source>
        <translation>Koniec przy uchwycie nierozstrzygnięty: leży od z {from_mm:3} do {to_mm:3} mm</translation>
    </message>
    <message>
        <source>U of its place</source>
        <translation>U położenia</translation>
    </message>
    <message>
        <source>U of its depth</source>
        <translation>U głębokości</translation>
    </message>
    <message>
        <source>U of its angle</source>
        <translation>U kąta</translation>
    </message>
    <message>
        <source>Stated length</source>
        <translation>Podana długość</translation>
    </message>
    <message>
        <source>By a person, where the scan does not show an end.</source>
        <translation>Przez człowieka, gdy skan nie pokazuje końca.</translation>
    </message>
    <message>
        <source>{path}: a pattern of {waves} waves in a revolution was found, {least} at the least. Light may double one wave, and less than one is no vibration of the cut: drift, light, a second feed or the scale make it. Whether there is chatter is undecided; photograph more of the circumference.</source>
        <translation>{path}: znaleziono wzór o {waves} falach na obrót, co najmniej {least}. Światło może podwoić jedną falę, a mniej niż jedna nie jest drganiem przy skrawaniu: powodują ją dryf, światło, drugi posuw albo skala. Czy jest drganie samowzbudne, pozostaje nierozstrzygnięte; proszę sfotografować większą część obwodu.</translation>
    </message>
    <message>
        <source>Standard uncertainty of m as measured</source>
        <translation>Niepewność standardowa zmierzonego m</translation>
    </message>
    <message>
        <source>feed marks, chatter undecided</source>
        <translation>ślady posuwu, drgania nierozstrzygnięte</translation>
    </message>
    <message>
        <source>Feed marks {pitch} mm apart; whether there is chatter is open.</source>
        <translation>Ślady posuwu co {pitch} mm; czy są drgania, pozostaje otwarte.</translation>
    </message>
    <message>
        <source>Feed marks {pitch} px apart; whether there is chatter is open.</source>
        <translation>Ślady posuwu co {pitch} px; czy są drgania, pozostaje otwarte.</translation>
    </message>
    <message>
        <source>Before, {rpm} rpm: whether there is chatter is open.</source>
        <translation>Przed, {rpm} obr/min: czy są drgania, pozostaje otwarte.</translation>
    </message>
    <message>
        <source>After, {rpm} rpm: whether there is chatter is open.</source>
        <translation>Po, {rpm} obr/min: czy są drgania, pozostaje otwarte.</translation>
    </message>
    <message>
        <source>The spindle at the chuck face, from SPINDLE.json; else that of the shop.</source>
        <translation>Wrzeciono na czole uchwytu, z SPINDLE.json; w przeciwnym razie z warsztatu.</translation>
    </message>
    <message>
        <source>Stock, set-up, tools and cutting data, from JOB.json; else from the shop.</source>
        <translation>Półfabrykat, ustawienie, narzędzia i parametry skrawania, z JOB.json; w przeciwnym razie z warsztatu.</translation>
    </message>
    <message>
        <source>SETUP.json; without a stock of its own it takes the job&apos;s bar; else from the shop, where the job is too or a SHOP.json is stated.</source>
        <translation>SETUP.json; bez własnego półfabrykatu bierze pręt zadania; w przeciwnym razie z warsztatu, gdy zadanie też jest z niego albo podano SHOP.json.</translation>
    </message>
    <message>
        <source>Shop</source>
        <translation>Warsztat</translation>
    </message>
    <message>
        <source>Makes what is not given of machine, job and set-up, marked as assumed: SHOP.json, or built-in; empty: their steps are missing.</source>
        <translation>Tworzy to, czego nie podano z maszyny, zadania i ustawienia, oznaczone jako przyjęte: SHOP.json albo built-in; puste: brakuje ich kroków.</translation>
    </message>
    <message>
        <source>The elastic modulus is that of the project&apos;s shaft, {modulus_MPa} MPa, as in the question Machine; the cutting coefficients stay those of the set-up.</source>
        <translation>Moduł sprężystości jest modułem wału z projektu, {modulus_MPa} MPa, jak w pytaniu Maszyna; współczynniki skrawania pozostają takie, jak w ustawieniu.</translation>
    </message>
    <message>
        <source>Springs of the chuck from the library that the question Machine uses.</source>
        <translation>Sprężyny uchwytu z biblioteki, z której korzysta pytanie Maszyna.</translation>
    </message>
    <message>
        <source>Elastic constants from the library that the question Machine uses. The cutting coefficients stay those of the set-up.</source>
        <translation>Stałe sprężyste z biblioteki, z której korzysta pytanie Maszyna. Współczynniki skrawania pozostają takie, jak w ustawieniu.</translation>
    </message>
    <message>
        <source>the number of a part, counted from 0</source>
        <translation>numer części, liczony od 0</translation>
    </message>
    <message>
        <source>As it is shown.</source>
        <translation>Tak jest pokazywana.</translation>
    </message>
    <message>
        <source>Largest speed</source>
        <translation>Największa prędkość obrotowa</translation>
    </message>
    <message>
        <source>Of the spindle.</source>
        <translation>Wrzeciona.</translation>
    </message>
    <message>
        <source>Empty: not looked at.</source>
        <translation>Puste: nie jest sprawdzane.</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Średnica toczenia</translation>
    </message>
    <message>
        <source>Largest diameter of a part; empty: not looked at.</source>
        <translation>Największa średnica części; puste: nie jest sprawdzana.</translation>
    </message>
    <message>
        <source>Turning length</source>
        <translation>Długość toczenia</translation>
    </message>
    <message>
        <source>Largest length of a part; empty: not looked at.</source>
        <translation>Największa długość części; puste: nie jest sprawdzana.</translation>
    </message>
    <message>
        <source>For which programs are written.</source>
        <translation>Dla którego pisane są programy.</translation>
    </message>
    <message>
        <source>With the spindle behind it.</source>
        <translation>Razem z wrzecionem za nim.</translation>
    </message>
    <message>
        <source>The least length to be held.</source>
        <translation>Najmniejsza długość zamocowania.</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Odstęp</translation>
    </message>
    <message>
        <source>From the part&apos;s end to the chuck face.</source>
        <translation>Od końca części do czoła uchwytu.</translation>
    </message>
    <message>
        <source>Against tilting of the axis; 0: a pointed centre.</source>
        <translation>Przeciw pochyleniu osi; 0: kieł ostry.</translation>
    </message>
    <message>
        <source>From slenderness</source>
        <translation>Od smukłości</translation>
    </message>
    <message>
        <source>Used where length over mean diameter is that large.</source>
        <translation>Używany, gdy stosunek długości do średniej średnicy jest co najmniej taki.</translation>
    </message>
    <message>
        <source>In the turret, by their number.</source>
        <translation>W głowicy, według numeru.</translation>
    </message>
    <message>
        <source>Stiffness and density</source>
        <translation>Sztywność i gęstość</translation>
    </message>
    <message>
        <source>Of this material.</source>
        <translation>Tego materiału.</translation>
    </message>
    <message>
        <source>With a coated carbide insert.</source>
        <translation>Z płytką z węglika powlekanego.</translation>
    </message>
    <message>
        <source>Allowance of the bar</source>
        <translation>Naddatek pręta</translation>
    </message>
    <message>
        <source>Its diameter beyond the largest of the part, at least.</source>
        <translation>O ile jego średnica jest co najmniej większa od największej średnicy części.</translation>
    </message>
    <message>
        <source>The shop has no {table} “{key}”; it has {known}.</source>
        <translation>Warsztat nie ma pozycji „{key}” (tabela: {table}); ma: {known}.</translation>
    </message>
    <message>
        <source>The part&apos;s largest diameter is {diameter_mm} mm; bars are listed up to {largest_mm} mm. State a job with the bar at hand.</source>
        <translation>Największa średnica części wynosi {diameter_mm} mm; pręty są wymienione do {largest_mm} mm. Podaj zadanie z prętem, który jest dostępny.</translation>
    </message>
    <message>
        <source>{what} is {found_mm} mm; the lathe “{lathe}” takes {most_mm} mm.</source>
        <translation>{what}: {found_mm} mm; tokarka „{lathe}” przyjmuje {most_mm} mm.</translation>
    </message>
    <message>
        <source>The shop makes {what} for a part: state it with {name}, or state {what}.</source>
        <translation>Warsztat tworzy {what} dla części: podaj ją przez {name} albo podaj {what}.</translation>
    </message>
    <message>
        <source>{what} of the shop: {value} ({source}).</source>
        <translation>{what} z warsztatu: {value} ({source}).</translation>
    </message>
    <message>
        <source>an object with a choice or tables of a shop</source>
        <translation>obiekt z wyborem albo tabelami warsztatu</translation>
    </message>
    <message>
        <source>Shops</source>
        <translation>Warsztaty</translation>
    </message>
    <message>
        <source>The diameter of the bar</source>
        <translation>Średnica pręta</translation>
    </message>
    <message>
        <source>The length of the part</source>
        <translation>Długość części</translation>
    </message>
    <message>
        <source>Lathe</source>
        <translation>Tokarka</translation>
    </message>
    <message>
        <source>Set of tools</source>
        <translation>Zestaw narzędzi</translation>
    </message>
    <message>
        <source>lathe</source>
        <translation>tokarka</translation>
    </message>
    <message>
        <source>set of tools</source>
        <translation>zestaw narzędzi</translation>
    </message>
    <message>
        <source>material</source>
        <translation>materiał</translation>
    </message>
    <message>
        <source>By its key in the tables of the shop.</source>
        <translation>Według klucza w tabelach warsztatu.</translation>
    </message>
    <message>
        <source>By its key; empty: the shop has none.</source>
        <translation>Według klucza; puste: warsztat go nie ma.</translation>
    </message>
    <message>
        <source>A post by its name; empty: that of the lathe.</source>
        <translation>Postprocesor według nazwy; puste: ten tokarki.</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabela</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Klucz</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Wybrane</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Źródło</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>wybrane</translation>
    </message>
    <message>
        <source>SHOP.json; without it the shop that is built in.</source>
        <translation>SHOP.json; bez niego warsztat wbudowany.</translation>
    </message>
    <message>
        <source>Chosen entries (SHOP.json)…</source>
        <translation>Wybrane pozycje (SHOP.json)…</translation>
    </message>
    <message>
        <source>Depths are multiples of the least limit, for K_r is not given · chatter at {frequency} Hz · lobes in the range: {lobes}</source>
        <translation>Głębokości są wielokrotnościami najmniejszej granicy, bo K_r nie podano · drgania przy {frequency} Hz · krzywe workowe w zakresie: {lobes}</translation>
    </message>
    <message>
        <source>Speed of the deepest stable cut</source>
        <translation>Prędkość najgłębszego stabilnego skrawania</translation>
    </message>
    <message>
        <source>“{place}” is answered, but nothing can be made from it before what it did not understand is settled.</source>
        <translation>„{place}” ma odpowiedź, ale nic nie może z niej wynikać, dopóki nie wyjaśni się tego, czego nie zrozumiano.</translation>
    </message>
    <message>
        <source>The button above runs the chain from the scan of a worn part to the proof of its copy; drop its files here, or a dossier that was made before.</source>
        <translation>Przycisk powyżej uruchamia łańcuch od skanu zużytej części do dowodu jej kopii; upuść tu jego pliki albo wcześniej utworzoną dokumentację.</translation>
    </message>
    <message>
        <source>Not taken: found {found}, expected {expected}.</source>
        <translation>Nie przyjęto: znaleziono {found}, oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>a file of no known kind</source>
        <translation>plik nieznanego rodzaju</translation>
    </message>
    <message>
        <source>a job or a set-up</source>
        <translation>zadanie albo ustawienie</translation>
    </message>
    <message>
        <source>Makes the job, set-up or spindle that is not given, from SHOP.json or the shop that is built-in; what nobody stated is marked as assumed.</source>
        <translation>Tworzy zadanie, ustawienie albo wrzeciono, których nie podano, z SHOP.json albo z warsztatu wbudowanego; to, czego nikt nie podał, jest oznaczone jako przyjęte.</translation>
    </message>
    <message>
        <source>Prediction and copy differ by</source>
        <translation>Przewidywanie i kopia różnią się o</translation>
    </message>
    <message>
        <source>|E_n| {error:2} · {agreeing} of {rows} rows agree within both uncertainties.</source>
        <translation>|E_n| {error:2} · {agreeing} z {rows} wierszy zgadza się w granicach obu niepewności.</translation>
    </message>
    <message>
        <source>Largest error after the correction</source>
        <translation>Największy błąd po korekcji</translation>
    </message>
    <message>
        <source>corrected</source>
        <translation>skorygowano</translation>
    </message>
    <message>
        <source>{before} µm without the correction · largest change {correction} µm on diameter</source>
        <translation>{before} µm bez korekcji · największa zmiana {correction} µm na średnicy</translation>
    </message>
    <message>
        <source>The program follows the prediction to {residual:2} µm, allowed {allowed} µm</source>
        <translation>Program zgadza się z przewidywaniem do {residual:2} µm, dozwolone {allowed} µm</translation>
    </message>
    <message>
        <source>{changed} blocks changed, {added} added</source>
        <translation>zmieniono bloków: {changed}, dodano: {added}</translation>
    </message>
    <message>
        <source>Stiffness of the chuck face</source>
        <translation>Sztywność czoła uchwytu</translation>
    </message>
    <message>
        <source>N/µm</source>
        <translation>N/µm</translation>
    </message>
    <message>
        <source>The rod held out is reproduced to {residual} % · responses: {responses}</source>
        <translation>Odłożony pręt odtworzony do {residual} % · charakterystyk: {responses}</translation>
    </message>
    <message>
        <source>The rods are reproduced to {residual} % · responses: {responses}</source>
        <translation>Pręty odtworzone do {residual} % · charakterystyk: {responses}</translation>
    </message>
    <message>
        <source>Depth that is stable over the pass</source>
        <translation>Głębokość stabilna w całym przejściu</translation>
    </message>
    <message>
        <source>Depth that is stable here</source>
        <translation>Głębokość stabilna w tym miejscu</translation>
    </message>
    <message>
        <source>Grows {growth} % with each turn · {room_mm:2} mm too deep</source>
        <translation>Rośnie o {growth} % na obrót · o {room_mm:2} mm za głęboko</translation>
    </message>
    <message>
        <source>Grows {growth} % with each turn</source>
        <translation>Rośnie o {growth} % na obrót</translation>
    </message>
    <message>
        <source>Dies away by {growth} % with each turn · {room_mm:2} mm to the limit</source>
        <translation>Zanika o {growth} % na obrót · {room_mm:2} mm do granicy</translation>
    </message>
    <message>
        <source>Dies away by {growth} % with each turn</source>
        <translation>Zanika o {growth} % na obrót</translation>
    </message>
    <message>
        <source>{speed} 1/min · {frequency} Hz · {k} whole waves, ε = {phase}°</source>
        <translation>{speed} obr/min · {frequency} Hz · całych fal: {k}, ε = {phase}°</translation>
    </message>
    <message>
        <source>{speed} 1/min · {frequency} Hz · no lobe limits here</source>
        <translation>{speed} obr/min · {frequency} Hz · żaden worek tu nie ogranicza</translation>
    </message>
    <message>
        <source>What it says</source>
        <translation>Co mówi</translation>
    </message>
    <message>
        <source>{step} · {state}</source>
        <translation>{step} · {state}</translation>
    </message>
    <message>
        <source>Annex</source>
        <translation>Załącznik</translation>
    </message>
    <message>
        <source>Notes, numbers and files</source>
        <translation>Uwagi, liczby i pliki</translation>
    </message>
    <message>
        <source>From the worn part to its copy</source>
        <translation>Od zużytej części do jej kopii</translation>
    </message>
    <message>
        <source>Open points</source>
        <translation>Punkty otwarte</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>✗ a step is out</source>
        <translation>✗ krok poza tolerancją</translation>
    </message>
    <message>
        <source>? a step is undecided</source>
        <translation>? krok nierozstrzygnięty</translation>
    </message>
    <message>
        <source>{step}: out of tolerance as programmed, and corrected</source>
        <translation>{step}: według programu poza tolerancją, skorygowano</translation>
    </message>
    <message>
        <source>{phase}° of a wave from one turn to the next; {relative} times as strong as the feed marks. Diameter, scale and speed give the frequency.</source>
        <translation>{phase}° fali między kolejnymi obrotami; {relative} razy silniejsze niż ślady posuwu. Średnica, skala i prędkość dają częstotliwość.</translation>
    </message>
    <message>
        <source>{waves} waves in a turn at {rpm} rpm: forced or regenerative? A whole number of waves speaks for stock, jaws, bearings or gears.</source>
        <translation>{waves} fal na obrót przy {rpm} obr/min: wymuszone czy regeneracyjne? Całkowita liczba fal wskazuje na półfabrykat, szczęki, łożyska lub koła zębate.</translation>
    </message>
    <message>
        <source>{waves} waves in a turn at {rpm} rpm, {relative} times as strong as the feed marks.</source>
        <translation>{waves} fal na obrót przy {rpm} obr/min, {relative} razy silniejsze niż ślady posuwu.</translation>
    </message>
    <message>
        <source>{waves} waves in a turn at {rpm} rpm. The picture leaves open: {others} Hz.</source>
        <translation>{waves} fal na obrót przy {rpm} obr/min. Obraz nie wyklucza także: {others} Hz.</translation>
    </message>
    <message>
        <source>Error motion allowed</source>
        <translation>Dopuszczalny błąd ruchu</translation>
    </message>
    <message>
        <source>Limit of the total error motion of the workpiece axis (ISO 230-7), probe X3.</source>
        <translation>Granica całkowitego błędu ruchu osi przedmiotu (ISO 230-7), czujnik X3.</translation>
    </message>
    <message>
        <source>U of the synchronous error motion (k = 2)</source>
        <translation>U synchronicznego błędu ruchu (k = 2)</translation>
    </message>
    <message>
        <source>U of the total error motion (k = 2)</source>
        <translation>U całkowitego błędu ruchu (k = 2)</translation>
    </message>
    <message>
        <source>Motion that repeats with every turn</source>
        <translation>Ruch powtarzający się co obrót</translation>
    </message>
    <message>
        <source>Only averages of {turns} turns are known · probe X3</source>
        <translation>Znane są tylko średnie z {turns} obrotów · czujnik X3</translation>
    </message>
    <message>
        <source>Deflection per force</source>
        <translation>Ugięcie na jednostkę siły</translation>
    </message>
    <message>
        <source>The annexes are in the folder of the chain; all notes, numbers and files with their digests are in {file}.</source>
        <translation>Załączniki są w folderze łańcucha; wszystkie uwagi, liczby i pliki ze skrótami są w {file}.</translation>
    </message>
    <message>
        <source>Predicted and measured: |E_n| {error:2}, at most 1 is agreement</source>
        <translation>Przewidziane i zmierzone: |E_n| {error:2}, zgodność to najwyżej 1</translation>
    </message>
    <message>
        <source>Confirmed by a person who is not named: {file}.</source>
        <translation>Zatwierdziła osoba bez podanego nazwiska: {file}.</translation>
    </message>
    <message>
        <source>Confirmed by {by}: {file}.</source>
        <translation>Zatwierdził(a) {by}: {file}.</translation>
    </message>
    <message>
        <source>dossier.json, which names all files: SHA-256 {sha256}.</source>
        <translation>dossier.json, który wymienia wszystkie pliki: SHA-256 {sha256}.</translation>
    </message>
    <message>
        <source>Motion of the workpiece axis {total:1} ± {U:1} µm, limit {limit} µm · section {section}</source>
        <translation>Ruch osi przedmiotu {total:1} ± {U:1} µm, granica {limit} µm · przekrój {section}</translation>
    </message>
    <message>
        <source>Motion of the workpiece axis: only averages are known, limit {limit} µm</source>
        <translation>Ruch osi przedmiotu: znane są tylko średnie, granica {limit} µm</translation>
    </message>
    <message>
        <source>Motion of the workpiece axis {total:1} µm, limit {limit} µm · section {section}</source>
        <translation>Ruch osi przedmiotu {total:1} µm, granica {limit} µm · przekrój {section}</translation>
    </message>
    <message>
        <source>a database without the tables of an archive</source>
        <translation>baza danych bez tabel archiwum</translation>
    </message>
    <message>
        <source>The evaluation says that its key is {found}; its content gives {expected}. It was altered.</source>
        <translation>Ocena podaje klucz {found}, a z jej treści wynika {expected}. Została zmieniona.</translation>
    </message>
    <message>
        <source>The location {location} holds a password, which others could see. Put it into ~/.pgpass or into the service file.</source>
        <translation>Położenie {location} zawiera hasło, które inni mogliby zobaczyć. Należy je wpisać do ~/.pgpass albo do pliku usług.</translation>
    </message>
    <message>
        <source>The location {location} is not understood; expected {expected}.</source>
        <translation>Położenie {location} jest niezrozumiałe; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>{location}: sslmode is {found}. Over the network expected require, verify-ca or verify-full.</source>
        <translation>{location}: sslmode to {found}. Przez sieć oczekiwano require, verify-ca albo verify-full.</translation>
    </message>
    <message>
        <source>The archive {location} cannot be opened: {reason}.</source>
        <translation>Archiwum {location} nie daje się otworzyć: {reason}.</translation>
    </message>
    <message>
        <source>The archive {location} cannot be read: {reason}.</source>
        <translation>Archiwum {location} nie daje się odczytać: {reason}.</translation>
    </message>
    <message>
        <source>The archive {location} cannot be written: {reason}.</source>
        <translation>Do archiwum {location} nie można pisać: {reason}.</translation>
    </message>
    <message>
        <source>{location} is no archive: found {found}.</source>
        <translation>{location} nie jest archiwum: znaleziono {found}.</translation>
    </message>
    <message>
        <source>The archive {location} is there already.</source>
        <translation>Archiwum {location} już istnieje.</translation>
    </message>
    <message>
        <source>The archive {location} has the version {found}; this program knows versions up to {expected}.</source>
        <translation>Archiwum {location} ma wersję {found}; ten program zna wersje do {expected}.</translation>
    </message>
    <message>
        <source>The archive {location} has the version {found} and could not be brought to version {expected}: {reason}. Who made it has to open it once.</source>
        <translation>Archiwum {location} ma wersję {found} i nie udało się doprowadzić go do wersji {expected}: {reason}. Musi je raz otworzyć ten, kto je utworzył.</translation>
    </message>
    <message>
        <source>{location} lies on {file_system}, where a file that several programs write is not safe. Use a local disk, or PostgreSQL.</source>
        <translation>{location} leży na {file_system}, gdzie plik zapisywany przez kilka programów nie jest bezpieczny. Należy użyć dysku lokalnego albo PostgreSQL.</translation>
    </message>
    <message>
        <source>The archive {location} was altered: the row {sequence} of the writer {writer} is broken ({fault}).</source>
        <translation>Archiwum {location} zostało zmienione: wiersz {sequence} piszącego {writer} jest naruszony ({fault}).</translation>
    </message>
    <message>
        <source>The rows of the writer {writer} differ from row {sequence} on: a copy of the archive was continued in two places. {location} was left as it is.</source>
        <translation>Wiersze piszącego {writer} różnią się od wiersza {sequence}: kopia archiwum była kontynuowana w dwóch miejscach. {location} pozostawiono bez zmian.</translation>
    </message>
    <message>
        <source>The recipe {sha256} is in the archive with another content.</source>
        <translation>Receptura {sha256} jest w archiwum z inną treścią.</translation>
    </message>
    <message>
        <source>{name} cannot be kept: expected UTF-8 without the character 0, of a result JSON.</source>
        <translation>{name} nie może być zachowane: oczekiwano UTF-8 bez znaku 0, a jako wyniku JSON.</translation>
    </message>
    <message>
        <source>The archive holds no evaluation {uuid}.</source>
        <translation>W archiwum nie ma oceny {uuid}.</translation>
    </message>
    <message>
        <source>Several evaluations begin with {uuid}; expected {expected}.</source>
        <translation>Kilka ocen zaczyna się od {uuid}; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The evaluation {uuid} is superseded by {superseded_by} already.</source>
        <translation>Ocena {uuid} jest już zastąpiona przez {superseded_by}.</translation>
    </message>
    <message>
        <source>Who replaces an evaluation states why: the reason is missing.</source>
        <translation>Kto zastępuje ocenę, podaje dlaczego: brakuje powodu.</translation>
    </message>
    <message>
        <source>The archive holds no value of {characteristic}.</source>
        <translation>W archiwum nie ma wartości cechy {characteristic}.</translation>
    </message>
    <message>
        <source>{characteristic} is a characteristic of several tasks or units: {found}. State one.</source>
        <translation>{characteristic} jest cechą kilku zadań lub jednostek: {found}. Należy podać jedno z nich.</translation>
    </message>
    <message>
        <source>The last line has no end: the file was cut. Its first characters are “{found}”.</source>
        <translation>Ostatni wiersz nie ma końca: plik został ucięty. Jego pierwsze znaki to „{found}”.</translation>
    </message>
    <message>
        <source>One evaluation takes the place of another; found {found}.</source>
        <translation>Jedna ocena zajmuje miejsce innej; znaleziono {found}.</translation>
    </message>
    <message>
        <source>{location}: this role may not make the group roles {roles}. An administrator makes them and grants them what they may do.</source>
        <translation>{location}: ta rola nie może utworzyć ról grupowych {roles}. Tworzy je administrator i nadaje im uprawnienia.</translation>
    </message>
    <message>
        <source>Archives of evaluations</source>
        <translation>Archiwa ocen</translation>
    </message>
    <message>
        <source>more characters of the UUID, at least 4</source>
        <translation>więcej znaków UUID, co najmniej 4</translation>
    </message>
    <message>
        <source>its content is not what was recorded</source>
        <translation>jego treść nie jest tą, którą zapisano</translation>
    </message>
    <message>
        <source>it does not follow the row before it</source>
        <translation>nie następuje po poprzednim wierszu</translation>
    </message>
    <message>
        <source>it is missing</source>
        <translation>brakuje go</translation>
    </message>
    <message>
        <source>its place is taken twice</source>
        <translation>jego miejsce jest zajęte dwa razy</translation>
    </message>
    <message>
        <source>its values are not those of its result</source>
        <translation>jego wartości nie są wartościami jego wyniku</translation>
    </message>
    <message>
        <source>its recipe is not what was recorded</source>
        <translation>jego receptura nie jest tą, którą zapisano</translation>
    </message>
    <message>
        <source>values belong to no row</source>
        <translation>wartości nie należą do żadnego wiersza</translation>
    </message>
    <message>
        <source>a date such as 2026-11-29</source>
        <translation>data, na przykład 2026-11-29</translation>
    </message>
    <message>
        <source>postgresql://user@host/database, host=… dbname=… or service=…</source>
        <translation>postgresql://użytkownik@host/baza, host=… dbname=… albo service=…</translation>
    </message>
    <message>
        <source>it can only be read</source>
        <translation>można z niego tylko czytać</translation>
    </message>
    <message>
        <source>this role may not do that</source>
        <translation>ta rola nie ma do tego prawa</translation>
    </message>
    <message>
        <source>another program holds it</source>
        <translation>zajmuje je inny program</translation>
    </message>
    <message>
        <source>the file is damaged</source>
        <translation>plik jest uszkodzony</translation>
    </message>
    <message>
        <source>the connection to the server was lost</source>
        <translation>utracono połączenie z serwerem</translation>
    </message>
    <message>
        <source>the server took too long</source>
        <translation>serwer odpowiadał zbyt długo</translation>
    </message>
    <message>
        <source>the server does not answer</source>
        <translation>serwer nie odpowiada</translation>
    </message>
    <message>
        <source>an empty file</source>
        <translation>pusty plik</translation>
    </message>
    <message>
        <source>a file that is no database of SQLite</source>
        <translation>plik, który nie jest bazą SQLite</translation>
    </message>
    <message>
        <source>a database of another program</source>
        <translation>baza danych innego programu</translation>
    </message>
    <message>
        <source>Evaluating the parts</source>
        <translation>Ocena części</translation>
    </message>
    <message>
        <source>The recipe was made with another content of {role}: SHA-256 is {found}, expected {expected}. Save the recipe anew, or bring the file back.</source>
        <translation>Recepturę utworzono z inną treścią „{role}”: SHA-256 to {found}, oczekiwano {expected}. Należy zapisać recepturę na nowo albo przywrócić plik.</translation>
    </message>
    <message>
        <source>The {role} of the recipe is not there; expected a file with the SHA-256 {expected}.</source>
        <translation>Brakuje „{role}” receptury; oczekiwano pliku o SHA-256 {expected}.</translation>
    </message>
    <message>
        <source>This program has no task “{found}”; it has {known}.</source>
        <translation>Ten program nie ma zadania „{found}”; ma {known}.</translation>
    </message>
    <message>
        <source>“{key}” is not known here; expected {expected}.</source>
        <translation>„{key}” jest tu nieznane; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The recipe has version {found}; this program reads up to version {maximum}.</source>
        <translation>Receptura ma wersję {found}; ten program czyta do wersji {maximum}.</translation>
    </message>
    <message>
        <source>{task}: nothing that was given changes from part to part; a recipe needs one of {roles}.</source>
        <translation>{task}: nic z podanych danych nie zmienia się od części do części; receptura wymaga jednego z: {roles}.</translation>
    </message>
    <message>
        <source>{task} has no input that changes from part to part: there is no recipe of it.</source>
        <translation>{task} nie ma wejścia, które zmienia się od części do części: nie ma dla niego receptury.</translation>
    </message>
    <message>
        <source>A recipe holds files: {role} is “{item}” of the project. Save it as a file, and choose that.</source>
        <translation>Receptura zawiera pliki: „{role}” to „{item}” z projektu. Należy zapisać to jako plik i wybrać plik.</translation>
    </message>
    <message>
        <source>A recipe cannot hold {parameter}: {found} is a file or folder, whose content is not that of the recipe.</source>
        <translation>Receptura nie może zawierać {parameter}: {found} jest plikiem lub folderem, którego treść nie jest treścią receptury.</translation>
    </message>
    <message>
        <source>Each part of this recipe has {roles}: state a list with one part a line, {&quot;inputs&quot;: {role: file}}.</source>
        <translation>Każda część tej receptury ma {roles}: należy podać listę z jedną częścią w wierszu, {&quot;inputs&quot;: {role: file}}.</translation>
    </message>
    <message>
        <source>The file holds the results of the recipe {found}; this one is {expected}. One folder is for one recipe.</source>
        <translation>Plik zawiera wyniki receptury {found}; ta to {expected}. Jeden folder jest dla jednej receptury.</translation>
    </message>
    <message>
        <source>Another run is writing these results.</source>
        <translation>Te wyniki zapisuje inny przebieg.</translation>
    </message>
    <message>
        <source>The folder remembers no earlier run: state the recipe and the files.</source>
        <translation>Folder nie pamięta wcześniejszego przebiegu: należy podać recepturę i pliki.</translation>
    </message>
    <message>
        <source>Parts without an answer: {failed} of {parts}; {file} says why.</source>
        <translation>Części bez odpowiedzi: {failed} z {parts}; powody są w {file}.</translation>
    </message>
    <message>
        <source>{path} has the content of {other}: it was evaluated once.</source>
        <translation>{path} ma treść {other}: oceniono to raz.</translation>
    </message>
    <message>
        <source>Further parts with the content of another: {count}.</source>
        <translation>Dalsze części o treści innej części: {count}.</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Części</translation>
    </message>
    <message>
        <source>within tolerance</source>
        <translation>w tolerancji</translation>
    </message>
    <message>
        <source>out of tolerance</source>
        <translation>poza tolerancją</translation>
    </message>
    <message>
        <source>answered without a verdict</source>
        <translation>z odpowiedzią bez orzeczenia</translation>
    </message>
    <message>
        <source>without an answer</source>
        <translation>bez odpowiedzi</translation>
    </message>
    <message>
        <source>with the content of another</source>
        <translation>o treści innej części</translation>
    </message>
    <message>
        <source>taken over from an earlier run</source>
        <translation>przejęte z wcześniejszego przebiegu</translation>
    </message>
    <message>
        <source>Parts without an answer</source>
        <translation>Części bez odpowiedzi</translation>
    </message>
    <message>
        <source>Exit code</source>
        <translation>Kod wyjścia</translation>
    </message>
    <message>
        <source>A recipe over many parts</source>
        <translation>Receptura dla wielu części</translation>
    </message>
    <message>
        <source>it does not open</source>
        <translation>nie otwiera się</translation>
    </message>
    <message>
        <source>an evaluation on one line</source>
        <translation>ocena w jednym wierszu</translation>
    </message>
    <message>
        <source>a recipe and its SHA-256</source>
        <translation>receptura i jej SHA-256</translation>
    </message>
    <message>
        <source>the inputs of a part by their roles</source>
        <translation>wejścia części według ról</translation>
    </message>
    <message>
        <source>at least one file</source>
        <translation>co najmniej jeden plik</translation>
    </message>
    <message>
        <source>the path of a file</source>
        <translation>ścieżka pliku</translation>
    </message>
    <message>
        <source>an input</source>
        <translation>wejście</translation>
    </message>
    <message>
        <source>a SHA-256 of 64 hexadecimal digits</source>
        <translation>SHA-256 o 64 cyfrach szesnastkowych</translation>
    </message>
    <message>
        <source>a SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>a reading option</source>
        <translation>opcja odczytu</translation>
    </message>
    <message>
        <source>each role once</source>
        <translation>każda rola raz</translation>
    </message>
    <message>
        <source>at least one role</source>
        <translation>co najmniej jedna rola</translation>
    </message>
    <message>
        <source>a name, or path and sha256</source>
        <translation>nazwa albo path i sha256</translation>
    </message>
    <message>
        <source>the name of a command</source>
        <translation>nazwa polecenia</translation>
    </message>
    <message>
        <source>a version</source>
        <translation>wersja</translation>
    </message>
    <message>
        <source>a list of roles</source>
        <translation>lista ról</translation>
    </message>
    <message>
        <source>a parameter of the task</source>
        <translation>parametr zadania</translation>
    </message>
    <message>
        <source>the path of a recipe</source>
        <translation>ścieżka receptury</translation>
    </message>
    <message>
        <source>a list of paths</source>
        <translation>lista ścieżek</translation>
    </message>
    <message>
        <source>i/n with i from 1 to n, such as 3/10</source>
        <translation>i/n z i od 1 do n, na przykład 3/10</translation>
    </message>
    <message>
        <source>Queueing parts</source>
        <translation>Ustawianie części w kolejce</translation>
    </message>
    <message>
        <source>The recipe is another one than when the part was queued: {found}, expected {expected}.</source>
        <translation>Receptura jest inna niż przy ustawianiu części w kolejce: {found}, oczekiwano {expected}.</translation>
    </message>
    <message>
        <source>The files of the part have another content than when it was queued.</source>
        <translation>Pliki części mają inną treść niż przy ustawianiu jej w kolejce.</translation>
    </message>
    <message>
        <source>{tries} workers were lost while they worked on this part; the last was {worker}.</source>
        <translation>Podczas pracy nad tą częścią utracono {tries} wykonawców; ostatnim był {worker}.</translation>
    </message>
    <message>
        <source>Parts without an answer: {failed}; the list of failures says why.</source>
        <translation>Części bez odpowiedzi: {failed}; powody są na liście niepowodzeń.</translation>
    </message>
    <message>
        <source>Waiting for parts</source>
        <translation>Oczekiwanie na części</translation>
    </message>
    <message>
        <source>Scanning the parts</source>
        <translation>Skanowanie części</translation>
    </message>
    <message>
        <source>unchanged</source>
        <translation>bez zmian</translation>
    </message>
    <message>
        <source>changed since</source>
        <translation>od tego czasu zmieniona</translation>
    </message>
    <message>
        <source>not there any more</source>
        <translation>już nie istnieje</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Wartości</translation>
    </message>
    <message>
        <source>… with a limit</source>
        <translation>… z granicą</translation>
    </message>
    <message>
        <source>… out of tolerance</source>
        <translation>… poza tolerancją</translation>
    </message>
    <message>
        <source>… that cannot be decided</source>
        <translation>… których nie można rozstrzygnąć</translation>
    </message>
    <message>
        <source>Pp (limits over 6 s)</source>
        <translation>Pp (granice przez 6 s)</translation>
    </message>
    <message>
        <source>Ppk (nearer limit over 3 s)</source>
        <translation>Ppk (bliższa granica przez 3 s)</translation>
    </message>
    <message>
        <source>Lower control limit</source>
        <translation>Dolna granica kontrolna</translation>
    </message>
    <message>
        <source>Upper control limit</source>
        <translation>Górna granica kontrolna</translation>
    </message>
    <message>
        <source>Values outside the control limits</source>
        <translation>Wartości poza granicami kontrolnymi</translation>
    </message>
    <message>
        <source>Most values in succession on one side of the mean</source>
        <translation>Najwięcej kolejnych wartości po jednej stronie średniej</translation>
    </message>
    <message>
        <source>Most values in succession that rise or fall</source>
        <translation>Najwięcej kolejnych wartości rosnących lub malejących</translation>
    </message>
    <message>
        <source>In statistical control</source>
        <translation>Proces ustabilizowany</translation>
    </message>
    <message>
        <source>Drift over 100 parts</source>
        <translation>Dryf na 100 części</translation>
    </message>
    <message>
        <source>… its uncertainty (95 %)</source>
        <translation>… jego niepewność (95 %)</translation>
    </message>
    <message>
        <source>The archive has no value of {characteristic} that satisfies what was asked for.</source>
        <translation>Archiwum nie ma wartości cechy {characteristic}, która spełnia to, o co pytano.</translation>
    </message>
    <message>
        <source>The archive has no evaluations with numbers yet.</source>
        <translation>Archiwum nie ma jeszcze ocen z liczbami.</translation>
    </message>
    <message>
        <source>The limits of the characteristic differ within the series: no capability is stated.</source>
        <translation>Granice cechy różnią się w obrębie serii: zdolności nie podano.</translation>
    </message>
    <message>
        <source>{count} values are few for a capability; at least {least} are usual.</source>
        <translation>{count} wartości to mało jak na zdolność; zwykle bierze się co najmniej {least}.</translation>
    </message>
    <message>
        <source>The series is not in statistical control: what its capability says of later parts is uncertain.</source>
        <translation>Proces nie jest ustabilizowany: to, co zdolność mówi o późniejszych częściach, jest niepewne.</translation>
    </message>
    <message>
        <source>The latest {count} values are taken; there may be earlier ones.</source>
        <translation>Wzięto {count} ostatnich wartości; mogą istnieć wcześniejsze.</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archiwum</translation>
    </message>
    <message>
        <source>Characteristic</source>
        <translation>Cecha</translation>
    </message>
    <message>
        <source>Its key, such as zones.seat.mean_mm; empty: the answer of the task.</source>
        <translation>Jej klucz, na przykład zones.seat.mean_mm; puste: odpowiedź zadania.</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Zadanie</translation>
    </message>
    <message>
        <source>Of which the characteristic is: compare, roundness…; empty: that of the latest evaluation.</source>
        <translation>Którego jest to cecha: compare, roundness…; puste: zadanie ostatniej oceny.</translation>
    </message>
    <message>
        <source>First date, such as 2026-11-29.</source>
        <translation>Pierwsza data, na przykład 2026-11-29.</translation>
    </message>
    <message>
        <source>Last date, included.</source>
        <translation>Ostatnia data, włącznie.</translation>
    </message>
    <message>
        <source>Most values</source>
        <translation>Najwięcej wartości</translation>
    </message>
    <message>
        <source>The latest so many.</source>
        <translation>Tyle ostatnich.</translation>
    </message>
    <message>
        <source>Recipe</source>
        <translation>Receptura</translation>
    </message>
    <message>
        <source>SHA-256 of the recipe; empty: any.</source>
        <translation>SHA-256 receptury; puste: dowolna.</translation>
    </message>
    <message>
        <source>Shown in detail: the UUID of its evaluation, or its beginning; empty: the latest.</source>
        <translation>Pokazana w szczegółach: UUID jej oceny albo jego początek; puste: ostatnia.</translation>
    </message>
    <message>
        <source>lower limit</source>
        <translation>dolna granica</translation>
    </message>
    <message>
        <source>upper limit</source>
        <translation>górna granica</translation>
    </message>
    <message>
        <source>control limits</source>
        <translation>granice kontrolne</translation>
    </message>
    <message>
        <source>Part {number}, {file}: {value} {unit}</source>
        <translation>Część {number}, {file}: {value} {unit}</translation>
    </message>
    <message>
        <source>Answer of {task}</source>
        <translation>Odpowiedź zadania {task}</translation>
    </message>
    <message>
        <source>Number of the part in the order of time</source>
        <translation>Numer części w kolejności czasu</translation>
    </message>
    <message>
        <source>± U</source>
        <translation>± U</translation>
    </message>
    <message>
        <source>part</source>
        <translation>część</translation>
    </message>
    <message>
        <source>time (UTC)</source>
        <translation>czas (UTC)</translation>
    </message>
    <message>
        <source>file</source>
        <translation>plik</translation>
    </message>
    <message>
        <source>Characteristics of the archive</source>
        <translation>Cechy w archiwum</translation>
    </message>
    <message>
        <source>task</source>
        <translation>zadanie</translation>
    </message>
    <message>
        <source>characteristic</source>
        <translation>cecha</translation>
    </message>
    <message>
        <source>key</source>
        <translation>klucz</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>jednostka</translation>
    </message>
    <message>
        <source>latest value (UTC)</source>
        <translation>ostatnia wartość (UTC)</translation>
    </message>
    <message>
        <source>Part in detail</source>
        <translation>Część w szczegółach</translation>
    </message>
    <message>
        <source>Evaluated (UTC)</source>
        <translation>Oceniono (UTC)</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Osoba</translation>
    </message>
    <message>
        <source>Calibrated on</source>
        <translation>Wzorcowano</translation>
    </message>
    <message>
        <source>Version of the program</source>
        <translation>Wersja programu</translation>
    </message>
    <message>
        <source>Recipe (SHA-256)</source>
        <translation>Receptura (SHA-256)</translation>
    </message>
    <message>
        <source>… its content</source>
        <translation>… jego treść</translation>
    </message>
    <message>
        <source>Supersedes</source>
        <translation>Zastępuje</translation>
    </message>
    <message>
        <source>Row in the archive</source>
        <translation>Wiersz w archiwum</translation>
    </message>
    <message>
        <source>Its SHA-256</source>
        <translation>Jego SHA-256</translation>
    </message>
    <message>
        <source>Characteristics of the part</source>
        <translation>Cechy części</translation>
    </message>
    <message>
        <source>Series</source>
        <translation>Seria</translation>
    </message>
    <message>
        <source>part {number} of {count}, {file}</source>
        <translation>część {number} z {count}, {file}</translation>
    </message>
    <message>
        <source>{out} of {count} parts out of tolerance; mean {mean} {unit}, Ppk {Ppk}, in control.</source>
        <translation>{out} z {count} części poza tolerancją; średnia {mean} {unit}, Ppk {Ppk}, proces ustabilizowany.</translation>
    </message>
    <message>
        <source>{out} of {count} parts out of tolerance; mean {mean} {unit}, Ppk {Ppk}, not in control.</source>
        <translation>{out} z {count} części poza tolerancją; średnia {mean} {unit}, Ppk {Ppk}, proces nieustabilizowany.</translation>
    </message>
    <message>
        <source>{out} of {count} parts out of tolerance; mean {mean} {unit}.</source>
        <translation>{out} z {count} części poza tolerancją; średnia {mean} {unit}.</translation>
    </message>
    <message>
        <source>{count} parts without a limit; mean {mean} {unit}.</source>
        <translation>{count} części bez granicy; średnia {mean} {unit}.</translation>
    </message>
    <message>
        <source>Reading the archive</source>
        <translation>Odczyt archiwum</translation>
    </message>
    <message>
        <source>Reading the pictures</source>
        <translation>Odczyt obrazów</translation>
    </message>
    <message>
        <source>Drop an archive of evaluations here, or state its database.</source>
        <translation>Upuść tu archiwum ocen albo podaj jego bazę danych.</translation>
    </message>
    <message>
        <source>nothing behind the archive</source>
        <translation>nic za archiwum</translation>
    </message>
    <message>
        <source>Made: {location}</source>
        <translation>Utworzono: {location}</translation>
    </message>
    <message>
        <source>the files of results to add</source>
        <translation>pliki wyników do dodania</translation>
    </message>
    <message>
        <source>--supersedes beside it</source>
        <translation>obok tego --supersedes</translation>
    </message>
    <message>
        <source>Added: {added}. Already there: {already_there}. Superseded: {superseded}.</source>
        <translation>Dodano: {added}. Już były: {already_there}. Zastąpiono: {superseded}.</translation>
    </message>
    <message>
        <source>one UUID, or its first characters</source>
        <translation>jeden UUID albo jego pierwsze znaki</translation>
    </message>
    <message>
        <source>the key of one characteristic</source>
        <translation>klucz jednej cechy</translation>
    </message>
    <message>
        <source>a file for the lines where --json is given</source>
        <translation>plik na wiersze, jeżeli podano --json</translation>
    </message>
    <message>
        <source>Lines written: {lines}</source>
        <translation>Zapisane wiersze: {lines}</translation>
    </message>
    <message>
        <source>the archive that the rows go to</source>
        <translation>archiwum, do którego idą wiersze</translation>
    </message>
    <message>
        <source>Pushed: {pushed}. Already there: {already_there}.</source>
        <translation>Przesłano: {pushed}. Już były: {already_there}.</translation>
    </message>
    <message>
        <source>create, add, list, show, characteristics, series, export, verify or push</source>
        <translation>create, add, list, show, characteristics, series, export, verify albo push</translation>
    </message>
    <message>
        <source>Time (UTC)</source>
        <translation>Czas (UTC)</translation>
    </message>
    <message>
        <source>Superseded by</source>
        <translation>Zastąpione przez</translation>
    </message>
    <message>
        <source>Evaluations</source>
        <translation>Oceny</translation>
    </message>
    <message>
        <source>Version</source>
        <translation>Wersja</translation>
    </message>
    <message>
        <source>Writer</source>
        <translation>Piszący</translation>
    </message>
    <message>
        <source>Place in the chain</source>
        <translation>Miejsce w łańcuchu</translation>
    </message>
    <message>
        <source>Hash</source>
        <translation>Skrót</translation>
    </message>
    <message>
        <source>Evaluation</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Last value (UTC)</source>
        <translation>Ostatnia wartość (UTC)</translation>
    </message>
    <message>
        <source>Characteristics</source>
        <translation>Cechy</translation>
    </message>
    <message>
        <source>Rows checked</source>
        <translation>Sprawdzone wiersze</translation>
    </message>
    <message>
        <source>Last hash</source>
        <translation>Ostatni skrót</translation>
    </message>
    <message>
        <source>Chains</source>
        <translation>Łańcuchy</translation>
    </message>
    <message>
        <source>All rows are what was recorded.</source>
        <translation>Wszystkie wiersze są takie, jak je zapisano.</translation>
    </message>
    <message>
        <source>BROKEN: the row {sequence} of the writer {writer} ({uuid}): {fault}.</source>
        <translation>NARUSZONY: wiersz {sequence} piszącego {writer} ({uuid}): {fault}.</translation>
    </message>
    <message>
        <source>a recipe, or --resume</source>
        <translation>receptura albo --resume</translation>
    </message>
    <message>
        <source>files, folders or lists, or --resume</source>
        <translation>pliki, foldery albo listy, albo --resume</translation>
    </message>
    <message>
        <source>a recipe, and files, folders or lists</source>
        <translation>receptura oraz pliki, foldery albo listy</translation>
    </message>
    <message>
        <source>add, work, show or retry</source>
        <translation>add, work, show albo retry</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Baza danych</translation>
    </message>
    <message>
        <source>Of the archive where it is no file: postgresql://HOST/NAME, service=NAME.</source>
        <translation>Archiwum, jeżeli nie jest plikiem: postgresql://HOST/NAZWA, service=NAZWA.</translation>
    </message>
    <message>
        <source>Evaluations kept by the command archive, in a file.</source>
        <translation>Oceny przechowywane przez polecenie archive, w pliku.</translation>
    </message>
    <message>
        <source>Archive or its database</source>
        <translation>Archiwum albo jego baza danych</translation>
    </message>
    <message>
        <source>pass, fail, undecided or null</source>
        <translation>pass, fail, undecided albo null</translation>
    </message>
    <message>
        <source>the key of the evaluation</source>
        <translation>klucz oceny</translation>
    </message>
    <message>
        <source>the key of a task</source>
        <translation>klucz zadania</translation>
    </message>
    <message>
        <source>the SHA-256 of the recipe</source>
        <translation>SHA-256 receptury</translation>
    </message>
    <message>
        <source>a list of inputs</source>
        <translation>lista wejść</translation>
    </message>
    <message>
        <source>a role</source>
        <translation>rola</translation>
    </message>
    <message>
        <source>a path</source>
        <translation>ścieżka</translation>
    </message>
    <message>
        <source>an exit code</source>
        <translation>kod wyjścia</translation>
    </message>
    <message>
        <source>a list of characteristics</source>
        <translation>lista cech</translation>
    </message>
    <message>
        <source>a characteristic</source>
        <translation>cecha</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>kHz</source>
        <translation>kHz</translation>
    </message>
    <message>
        <source>kg</source>
        <translation>kg</translation>
    </message>
    <message>
        <source>no request stands</source>
        <translation>nie ma pytania</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>odpowiedziano</translation>
    </message>
    <message>
        <source>no stable speed in the range</source>
        <translation>w zakresie nie ma stabilnej prędkości</translation>
    </message>
    <message>
        <source>a value is outside of what is allowed</source>
        <translation>wartość jest poza tym, co dozwolone</translation>
    </message>
    <message>
        <source>a value is missing or is no number</source>
        <translation>wartości brakuje albo nie jest liczbą</translation>
    </message>
    <message>
        <source>the machine runs</source>
        <translation>maszyna pracuje</translation>
    </message>
    <message>
        <source>the values changed while they were answered</source>
        <translation>wartości zmieniły się w czasie odpowiedzi</translation>
    </message>
    <message>
        <source>the stable speed is above the machine&apos;s highest speed</source>
        <translation>stabilna prędkość jest powyżej najwyższej prędkości maszyny</translation>
    </message>
    <message>
        <source>the response cannot be computed with these values</source>
        <translation>odpowiedzi układu nie można obliczyć z tymi wartościami</translation>
    </message>
    <message>
        <source>the control did not keep the speed that was written</source>
        <translation>sterowanie nie zachowało zapisanej prędkości</translation>
    </message>
    <message>
        <source>the loaded program does not give diameter and length</source>
        <translation>wczytany program nie daje średnicy i długości</translation>
    </message>
    <message>
        <source>something that could change the speed was not understood</source>
        <translation>nie zrozumiano czegoś, co mogłoby zmienić prędkość</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>czas</translation>
    </message>
    <message>
        <source>the number of a request</source>
        <translation>numer pytania</translation>
    </message>
    <message>
        <source>the values that were read</source>
        <translation>odczytane wartości</translation>
    </message>
    <message>
        <source>the number of a state</source>
        <translation>numer stanu</translation>
    </message>
    <message>
        <source>an event of the link</source>
        <translation>zdarzenie połączenia</translation>
    </message>
    <message>
        <source>No control answers at {peer}: {reason}.</source>
        <translation>Pod {peer} nie odpowiada żadne sterowanie: {reason}.</translation>
    </message>
    <message>
        <source>Another assistant is linked to the control at {peer}; two on one control are refused.</source>
        <translation>Ze sterowaniem {peer} jest połączony inny asystent; dwóch na jednym sterowaniu się odrzuca.</translation>
    </message>
    <message>
        <source>The link to the control at {peer} is lost: {reason}.</source>
        <translation>Utracono połączenie ze sterowaniem {peer}: {reason}.</translation>
    </message>
    <message>
        <source>The control at {peer} answers {found}, expected {expected}.</source>
        <translation>Sterowanie {peer} odpowiada {found}, oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The port {port} cannot be listened to: {reason}.</source>
        <translation>Nie można nasłuchiwać na porcie {port}: {reason}.</translation>
    </message>
    <message>
        <source>The register of {name} at {peer} cannot hold {found}: from {minimum} to {maximum}.</source>
        <translation>Rejestr wartości {name} w {peer} nie pomieści {found}: od {minimum} do {maximum}.</translation>
    </message>
    <message>
        <source>The configuration does not know {key}; expected {expected}.</source>
        <translation>Konfiguracja nie zna {key}; oczekiwano: {expected}.</translation>
    </message>
    <message>
        <source>The configuration says nothing about the link {kind}.</source>
        <translation>Konfiguracja nic nie mówi o połączeniu {kind}.</translation>
    </message>
    <message>
        <source>Line {line} of the program states {word}, which was not understood and could move the tool.</source>
        <translation>Wiersz {line} programu zawiera {word}, którego nie zrozumiano, a które mogłoby przesunąć narzędzie.</translation>
    </message>
    <message>
        <source>The program turns nothing: no feed move was found.</source>
        <translation>Program niczego nie toczy: nie znaleziono ruchu roboczego.</translation>
    </message>
    <message>
        <source>The request was refused: {state}.</source>
        <translation>Pytanie odrzucono: {state}.</translation>
    </message>
    <message>
        <source>Exchanges of the log that are answered otherwise today: {count} of {exchanges}, the first in line {line}.</source>
        <translation>Wymiany z dziennika, na które dziś odpowiedź jest inna: {count} z {exchanges}, pierwsza w wierszu {line}.</translation>
    </message>
    <message>
        <source>This kind of link was not verified on a real control: {kind}.</source>
        <translation>Tego rodzaju połączenia nie sprawdzono na prawdziwym sterowaniu: {kind}.</translation>
    </message>
    <message>
        <source>a value of this part</source>
        <translation>wartość z tej części</translation>
    </message>
    <message>
        <source>not 0</source>
        <translation>różne od 0</translation>
    </message>
    <message>
        <source>a register</source>
        <translation>rejestr</translation>
    </message>
    <message>
        <source>the registers by name</source>
        <translation>rejestry według nazw</translation>
    </message>
    <message>
        <source>Highest speed of the machine</source>
        <translation>Najwyższa prędkość maszyny</translation>
    </message>
    <message>
        <source>A stable speed above is refused.</source>
        <translation>Stabilna prędkość powyżej jest odrzucana.</translation>
    </message>
    <message>
        <source>Least diameter</source>
        <translation>Najmniejsza średnica</translation>
    </message>
    <message>
        <source>Below it a request is refused.</source>
        <translation>Poniżej pytanie jest odrzucane.</translation>
    </message>
    <message>
        <source>Greatest diameter</source>
        <translation>Największa średnica</translation>
    </message>
    <message>
        <source>Above it a request is refused.</source>
        <translation>Powyżej pytanie jest odrzucane.</translation>
    </message>
    <message>
        <source>Least overhang</source>
        <translation>Najmniejszy wysięg</translation>
    </message>
    <message>
        <source>Greatest overhang</source>
        <translation>Największy wysięg</translation>
    </message>
    <message>
        <source>From the turned length to the chuck; the overhang is both.</source>
        <translation>Od długości toczonej do uchwytu; wysięg to jedno i drugie.</translation>
    </message>
    <message>
        <source>Polling period</source>
        <translation>Okres odpytywania</translation>
    </message>
    <message>
        <source>Between two looks at the request.</source>
        <translation>Między dwoma spojrzeniami na pytanie.</translation>
    </message>
    <message>
        <source>Heartbeat</source>
        <translation>Sygnał życia</translation>
    </message>
    <message>
        <source>Its period.</source>
        <translation>Jego okres.</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Przerwa</translation>
    </message>
    <message>
        <source>Before a lost link is opened again.</source>
        <translation>Zanim utracone połączenie zostanie otwarte ponownie.</translation>
    </message>
    <message>
        <source>Time-out</source>
        <translation>Limit czasu</translation>
    </message>
    <message>
        <source>Of one answer of the control.</source>
        <translation>Jednej odpowiedzi sterowania.</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Host</translation>
    </message>
    <message>
        <source>Of the simulated control.</source>
        <translation>Sterowania symulowanego.</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Komponent</translation>
    </message>
    <message>
        <source>Its name in HAL, before that of each pin.</source>
        <translation>Jego nazwa w HAL, przed nazwą każdej końcówki.</translation>
    </message>
    <message>
        <source>Port of linuxcncrsh</source>
        <translation>Port linuxcncrsh</translation>
    </message>
    <message>
        <source>That names the loaded program; 0: it is not asked.</source>
        <translation>Który podaje wczytany program; 0: nie jest pytany.</translation>
    </message>
    <message>
        <source>Password of linuxcncrsh</source>
        <translation>Hasło linuxcncrsh</translation>
    </message>
    <message>
        <source>For this port.</source>
        <translation>Do tego portu.</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adres</translation>
    </message>
    <message>
        <source>Of its first byte in the R area.</source>
        <translation>Pierwszego bajtu w obszarze R.</translation>
    </message>
    <message>
        <source>1, 2 or 4.</source>
        <translation>1, 2 albo 4.</translation>
    </message>
    <message>
        <source>The value is the number times it.</source>
        <translation>Wartość jest liczbą razy skala.</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Biblioteka</translation>
    </message>
    <message>
        <source>FOCAS2 of the vendor, as it is installed.</source>
        <translation>FOCAS2 producenta, tak jak jest zainstalowana.</translation>
    </message>
    <message>
        <source>Of the control.</source>
        <translation>Sterowania.</translation>
    </message>
    <message>
        <source>a parameter of speed</source>
        <translation>parametr polecenia speed</translation>
    </message>
    <message>
        <source>the limits of the machine</source>
        <translation>granice maszyny</translation>
    </message>
    <message>
        <source>the control has started anew</source>
        <translation>sterowanie uruchomiono ponownie</translation>
    </message>
    <message>
        <source>a JSON object with the id of the question</source>
        <translation>obiekt JSON z numerem pytania</translation>
    </message>
    <message>
        <source>an answer without an error</source>
        <translation>odpowiedź bez błędu</translation>
    </message>
    <message>
        <source>numbers by name</source>
        <translation>liczby według nazw</translation>
    </message>
    <message>
        <source>the number of the message</source>
        <translation>numer wiadomości</translation>
    </message>
    <message>
        <source>names of values</source>
        <translation>nazwy wartości</translation>
    </message>
    <message>
        <source>the name of a value</source>
        <translation>nazwa wartości</translation>
    </message>
    <message>
        <source>values by name</source>
        <translation>wartości według nazw</translation>
    </message>
    <message>
        <source>Simulated control</source>
        <translation>Sterowanie symulowane</translation>
    </message>
    <message>
        <source>the name of a value that a control states</source>
        <translation>nazwa wartości, którą podaje sterowanie</translation>
    </message>
    <message>
        <source>shorter lines</source>
        <translation>krótsze wiersze</translation>
    </message>
    <message>
        <source>the path of ASSIST.json</source>
        <translation>ścieżka ASSIST.json</translation>
    </message>
    <message>
        <source>a kind of link, or --replay</source>
        <translation>rodzaj połączenia albo --replay</translation>
    </message>
    <message>
        <source>LinuxCNC runs as another user</source>
        <translation>LinuxCNC działa jako inny użytkownik</translation>
    </message>
    <message>
        <source>LinuxCNC does not run</source>
        <translation>LinuxCNC nie działa</translation>
    </message>
    <message>
        <source>the pins could not be made</source>
        <translation>nie udało się utworzyć końcówek</translation>
    </message>
    <message>
        <source>LinuxCNC has ended</source>
        <translation>LinuxCNC zakończył pracę</translation>
    </message>
    <message>
        <source>this program was built without LinuxCNC</source>
        <translation>ten program zbudowano bez LinuxCNC</translation>
    </message>
    <message>
        <source>FANUC (FOCAS2)</source>
        <translation>FANUC (FOCAS2)</translation>
    </message>
    <message>
        <source>Recipes</source>
        <translation>Receptury</translation>
    </message>
    <message>
        <source>a register that is written shares a byte with another</source>
        <translation>rejestr, do którego się pisze, dzieli bajt z innym</translation>
    </message>
    <message>
        <source>no answer within the time-out</source>
        <translation>brak odpowiedzi w limicie czasu</translation>
    </message>
    <message>
        <source>bytes of its own: what is written there changes another value</source>
        <translation>własne bajty: zapis zmienia tu inną wartość</translation>
    </message>
    <message>
        <source>bytes and a scale that hold each number that is written</source>
        <translation>bajty i skala, które mieszczą każdą zapisywaną liczbę</translation>
    </message>
    <message>
        <source>1 to 24 letters, digits, hyphens or underscores, a letter first</source>
        <translation>od 1 do 24 liter, cyfr, łączników albo podkreśleń, litera na początku</translation>
    </message>
    <message>
        <source>Links to controls</source>
        <translation>Połączenia ze sterowaniem</translation>
    </message>
    <message>
        <source>D or L is to come from the program, and the control names none that is loaded.</source>
        <translation>D albo L ma pochodzić z programu, a sterowanie nie podaje żadnego wczytanego.</translation>
    </message>
    <message>
        <source>The control asks with {found}, expected a whole number from 1 to {most}.</source>
        <translation>Sterowanie pyta liczbą {found}, oczekiwano liczby całkowitej od 1 do {most}.</translation>
    </message>
    <message>
        <source>nothing: the control states it at each request</source>
        <translation>niczego: sterowanie podaje to przy każdym pytaniu</translation>
    </message>
    <message>
        <source>nothing: the response is stated otherwise</source>
        <translation>niczego: odpowiedź układu podano inaczej</translation>
    </message>
    <message>
        <source>it does not keep what is written</source>
        <translation>nie zachowuje tego, co zapisano</translation>
    </message>
    <message>
        <source>a control of version 1 of the messages</source>
        <translation>sterowanie z wersją 1 wiadomości</translation>
    </message>
    <message>
        <source>a longer line</source>
        <translation>dłuższy wiersz</translation>
    </message>
    <message>
        <source>that it was written</source>
        <translation>potwierdzenie zapisu</translation>
    </message>
</context>
<context>
    <name>Languages</name>
    <message>
        <source>English</source>
        <translation>Polski</translation>
    </message>
</context>
<context>
    <name>TurningExports</name>
    <message>
        <source>Programs of both clampings</source>
        <translation>Programy obu zamocowań</translation>
    </message>
    <message>
        <source>Already there: %1. Replace?</source>
        <translation>Już istnieją: %1. Zastąpić?</translation>
    </message>
</context>
<context>
    <name>lathelier::AnswerStrip</name>
    <message>
        <source>Click: use it. It can be undone.</source>
        <translation>Kliknięcie: użyj. Można to cofnąć.</translation>
    </message>
</context>
<context>
    <name>lathelier::CommandPalette</name>
    <message>
        <source>Commands</source>
        <translation>Polecenia</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Wpisz, co chcesz zrobić</translation>
    </message>
    <message>
        <source>Nothing found: open the manual</source>
        <translation>Nic nie znaleziono: otwórz podręcznik</translation>
    </message>
</context>
<context>
    <name>lathelier::CopyTable</name>
    <message>
        <source>Copy</source>
        <translation>Kopiuj</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Kopiuj wszystko</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Wielkość</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wartość</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
</context>
<context>
    <name>lathelier::DataColumn</name>
    <message>
        <source>Nothing yet: drop files anywhere.</source>
        <translation>Jeszcze nic: upuść pliki w dowolnym miejscu.</translation>
    </message>
    <message>
        <source>Synthetic data: made by a program, not measured</source>
        <translation>Dane syntetyczne: z programu, nie z pomiaru</translation>
    </message>
    <message>
        <source>made in %1</source>
        <translation>powstało w panelu %1</translation>
    </message>
    <message>
        <source>its origin has changed since</source>
        <translation>jego źródło od tego czasu się zmieniło</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Copy the path</source>
        <translation>Kopiuj ścieżkę</translation>
    </message>
    <message>
        <source>Remove from the project</source>
        <translation>Usuń z projektu</translation>
    </message>
    <message>
        <source>Remove “%1”</source>
        <translation>Usuń „%1”</translation>
    </message>
    <message>
        <source>Data of the project</source>
        <translation>Dane projektu</translation>
    </message>
</context>
<context>
    <name>lathelier::EmptyPlace</name>
    <message>
        <source>All panels of “%1” are closed or stand in windows of their own.</source>
        <translation>Wszystkie panele pytania „%1” są zamknięte albo stoją we własnych oknach.</translation>
    </message>
    <message>
        <source>&amp;Bring them back</source>
        <translation>&amp;Przywróć je</translation>
    </message>
</context>
<context>
    <name>lathelier::EmptyState</name>
    <message>
        <source>Open…</source>
        <translation>Otwórz…</translation>
    </message>
    <message>
        <source>Open the sample</source>
        <translation>Otwórz przykład</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Obliczanie…</translation>
    </message>
</context>
<context>
    <name>lathelier::FieldEditor</name>
    <message>
        <source>not given</source>
        <translation>nie podano</translation>
    </message>
</context>
<context>
    <name>lathelier::FindingLink</name>
    <message>
        <source>no finding</source>
        <translation>bez wskazań</translation>
    </message>
</context>
<context>
    <name>lathelier::Form</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>assumed: %1</source>
        <translation>założono: %1</translation>
    </message>
    <message>
        <source>from the file: %1</source>
        <translation>z pliku: %1</translation>
    </message>
    <message numerus="yes">
        <source>More (%n assumed)</source>
        <translation>
            <numerusform>Więcej (%n przyjęta)</numerusform>
            <numerusform>Więcej (%n przyjęte)</numerusform>
            <numerusform>Więcej (%n przyjętych)</numerusform>
        </translation>
    </message>
    <message>
        <source>More</source>
        <translation>Więcej</translation>
    </message>
</context>
<context>
    <name>lathelier::HelpWindow</name>
    <message>
        <source>Lathelier help</source>
        <translation>Pomoc programu Lathelier</translation>
    </message>
    <message>
        <source>About Lathelier</source>
        <translation>O programie Lathelier</translation>
    </message>
    <message>
        <source>A desktop workbench for turning shops: scan, predict, cut without chatter, measure, prove.

Free software under the GNU General Public License, version 3 or later. It works offline; your files stay with you.</source>
        <translation>Warsztat dla tokarni: skanuj, przewiduj, tocz bez drgań, mierz, dowodź.

Wolne oprogramowanie na licencji GNU General Public License, wersja 3 lub nowsza. Działa bez sieci; Twoje pliki zostają u Ciebie.</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Szukaj w podręczniku</translation>
    </message>
    <message>
        <source>Words that a page has to have, all of them; Enter goes to the next place</source>
        <translation>Słowa, które strona musi zawierać, wszystkie; Enter przechodzi do następnego miejsca</translation>
    </message>
    <message>
        <source>No page has all of these words.</source>
        <translation>Żadna strona nie zawiera wszystkich tych słów.</translation>
    </message>
    <message>
        <source>Pages of the manual</source>
        <translation>Strony podręcznika</translation>
    </message>
    <message>
        <source>Page of the manual</source>
        <translation>Strona podręcznika</translation>
    </message>
</context>
<context>
    <name>lathelier::InputBox</name>
    <message>
        <source>unit %1 (assumed)</source>
        <translation>jednostka %1 (przyjęta)</translation>
    </message>
    <message>
        <source>unit %1</source>
        <translation>jednostka %1</translation>
    </message>
    <message>
        <source>decimal comma</source>
        <translation>przecinek dziesiętny</translation>
    </message>
    <message>
        <source>⚠ This file could not be read.</source>
        <translation>⚠ Nie udało się odczytać tego pliku.</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
    <message>
        <source>Open a file as “%1”</source>
        <translation>Otwórz plik jako „%1”</translation>
    </message>
    <message>
        <source>Take “%1” away</source>
        <translation>Usuń „%1”</translation>
    </message>
    <message>
        <source>How to read this file: unit, decimal mark, columns</source>
        <translation>Jak czytać ten plik: jednostka, znak dziesiętny, kolumny</translation>
    </message>
    <message>
        <source>binary</source>
        <translation>binarny</translation>
    </message>
    <message>
        <source>text</source>
        <translation>tekstowy</translation>
    </message>
    <message>
        <source>rows skipped: %L1</source>
        <translation>pominięte wiersze: %L1</translation>
    </message>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 i jeszcze %n</numerusform>
            <numerusform>%1 i jeszcze %n</numerusform>
            <numerusform>%1 i jeszcze %n</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” of this project</source>
        <translation>„%1” z tego projektu</translation>
    </message>
    <message>
        <source>Made in %1</source>
        <translation>Utworzono w: %1</translation>
    </message>
    <message>
        <source>⚠ %1 has another state by now: keep it there again to use it.</source>
        <translation>⚠ %1 ma już inny stan: zachowaj wynik ponownie, aby go użyć.</translation>
    </message>
    <message>
        <source>Use what another panel made as “%1”</source>
        <translation>Użyj wyniku innego panelu jako „%1”</translation>
    </message>
    <message>
        <source>%1 (required)</source>
        <translation>%1 (wymagane)</translation>
    </message>
    <message>
        <source>from the shop (assumed)</source>
        <translation>z warsztatu (przyjęte)</translation>
    </message>
    <message>
        <source>from “%1”</source>
        <translation>z „%1”</translation>
    </message>
</context>
<context>
    <name>lathelier::InputColumn</name>
    <message>
        <source>Change: %1</source>
        <translation>Zmień: %1</translation>
    </message>
    <message>
        <source>Take away: %1</source>
        <translation>Usuń: %1</translation>
    </message>
    <message>
        <source>Change how to read: %1</source>
        <translation>Zmień sposób odczytu: %1</translation>
    </message>
    <message>
        <source>Open: %1</source>
        <translation>Otwórz: %1</translation>
    </message>
    <message>
        <source>Use “%1”</source>
        <translation>Użyj „%1”</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Otwórz plik…</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>Dodaj…</translation>
    </message>
    <message>
        <source>Add what this panel can use besides: a file, or what another panel made</source>
        <translation>Dodaj, z czego panel może ponadto korzystać: plik albo to, co utworzył inny panel</translation>
    </message>
    <message>
        <source>Add an input</source>
        <translation>Dodaj wejście</translation>
    </message>
</context>
<context>
    <name>lathelier::IntervalsEdit</name>
    <message>
        <source>Add a range</source>
        <translation>Dodaj przedział</translation>
    </message>
    <message>
        <source>%1, from</source>
        <translation>%1, od</translation>
    </message>
    <message>
        <source>%1, to</source>
        <translation>%1, do</translation>
    </message>
    <message>
        <source>Remove this range</source>
        <translation>Usuń ten przedział</translation>
    </message>
</context>
<context>
    <name>lathelier::MainWindow</name>
    <message>
        <source>All files (*)</source>
        <translation>Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Unnamed project</source>
        <translation>Projekt bez nazwy</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Cofnij: %1</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Cofnij</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Ponów: %1</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Ponów</translation>
    </message>
    <message>
        <source>&amp;New project</source>
        <translation>&amp;Nowy projekt</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otwórz…</translation>
    </message>
    <message>
        <source>Open the sa&amp;mple</source>
        <translation>Otwórz prz&amp;ykład</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Zapisz</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Z&amp;apisz jako…</translation>
    </message>
    <message>
        <source>Project report as &amp;HTML…</source>
        <translation>Raport projektu &amp;HTML…</translation>
    </message>
    <message>
        <source>Project report as &amp;PDF…</source>
        <translation>Raport projektu &amp;PDF…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Za&amp;kończ</translation>
    </message>
    <message>
        <source>&amp;Settings…</source>
        <translation>&amp;Ustawienia…</translation>
    </message>
    <message>
        <source>&amp;Stop the computation</source>
        <translation>Przer&amp;wij obliczenia</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Przywróć układ &amp;okien</translation>
    </message>
    <message>
        <source>&amp;Presenter mode</source>
        <translation>Tryb &amp;prezentacji</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Pełny &amp;ekran</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Po&amp;moc</translation>
    </message>
    <message>
        <source>All &amp;commands…</source>
        <translation>Wszystkie po&amp;lecenia…</translation>
    </message>
    <message>
        <source>&amp;About Lathelier</source>
        <translation>&amp;O programie Lathelier</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Plik</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ostatnio &amp;używane</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Edycja</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Widok</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Komunikaty</translation>
    </message>
    <message>
        <source>Computing what belongs in the report…</source>
        <translation>Obliczanie wyników do raportu…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Zapisz raport</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Raport</translation>
    </message>
    <message>
        <source>&amp;Verify installation</source>
        <translation>Sprawdź &amp;instalację</translation>
    </message>
    <message>
        <source>Open a project or measured files</source>
        <translation>Otwórz projekt lub pliki pomiarowe</translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation>&amp;Następny panel</translation>
    </message>
    <message>
        <source>Pre&amp;vious panel</source>
        <translation>&amp;Poprzedni panel</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>Zapisywanie raportu…</translation>
    </message>
    <message>
        <source>&amp;Title block of the reports…</source>
        <translation>&amp;Tabliczka raportów…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>Opens the report that was saved last</source>
        <translation>Otwiera ostatnio zapisany raport</translation>
    </message>
    <message>
        <source>Change the title block</source>
        <translation>Zmiana tabliczki</translation>
    </message>
    <message>
        <source>Save as &amp;recipe…</source>
        <translation>Zapisz jako &amp;recepturę…</translation>
    </message>
    <message>
        <source>Ne&amp;xt part…</source>
        <translation>&amp;Następna część…</translation>
    </message>
    <message>
        <source>Use “%1”</source>
        <translation>Użycie „%1”</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Dane</translation>
    </message>
    <message>
        <source>S&amp;hop…</source>
        <translation>Wars&amp;ztat…</translation>
    </message>
    <message>
        <source>F&amp;loat or dock the panel</source>
        <translation>Odłącz a&amp;lbo zadokuj panel</translation>
    </message>
    <message>
        <source>&amp;Close the panel</source>
        <translation>&amp;Zamknij panel</translation>
    </message>
    <message>
        <source>C&amp;ompute again</source>
        <translation>&amp;Oblicz ponownie</translation>
    </message>
    <message>
        <source>&amp;Questions</source>
        <translation>&amp;Pytania</translation>
    </message>
    <message>
        <source>P&amp;anels</source>
        <translation>P&amp;anele</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Pytania</translation>
    </message>
    <message>
        <source>&amp;Dock</source>
        <translation>&amp;Zadokuj</translation>
    </message>
    <message>
        <source>&amp;Float</source>
        <translation>&amp;Odłącz</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Zamknij</translation>
    </message>
</context>
<context>
    <name>lathelier::MessageLog</name>
    <message>
        <source>Note</source>
        <translation>Uwaga</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Ostrzeżenie</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Błąd</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Czas</translation>
    </message>
    <message>
        <source>Panel</source>
        <translation>Panel</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Komunikat</translation>
    </message>
    <message>
        <source>Message log</source>
        <translation>Dziennik komunikatów</translation>
    </message>
    <message>
        <source>Copy the selected messages, or all</source>
        <translation>Kopiuj zaznaczone komunikaty albo wszystkie</translation>
    </message>
    <message>
        <source>Clear the log</source>
        <translation>Wyczyść dziennik</translation>
    </message>
</context>
<context>
    <name>lathelier::NextPartBar</name>
    <message>
        <source>“%1” is the next part: it took the place of “%2”, everything else stays.</source>
        <translation>„%1” to następna część: zajęła miejsce „%2”, reszta pozostaje.</translation>
    </message>
    <message>
        <source>Use as “%1” instead</source>
        <translation>Użyj zamiast tego jako „%1”</translation>
    </message>
    <message>
        <source>Leave it so</source>
        <translation>Zostaw tak</translation>
    </message>
</context>
<context>
    <name>lathelier::NotesChips</name>
    <message numerus="yes">
        <source>%n warning(s)</source>
        <translation>
            <numerusform>%n ostrzeżenie</numerusform>
            <numerusform>%n ostrzeżenia</numerusform>
            <numerusform>%n ostrzeżeń</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n note(s)</source>
        <translation>
            <numerusform>%n uwaga</numerusform>
            <numerusform>%n uwagi</numerusform>
            <numerusform>%n uwag</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>lathelier::NumberEdit</name>
    <message>
        <source>Expected a whole number from %1 to %2.</source>
        <translation>Oczekiwano liczby całkowitej od %1 do %2.</translation>
    </message>
    <message>
        <source>Expected a number from %1 to %2.</source>
        <translation>Oczekiwano liczby od %1 do %2.</translation>
    </message>
    <message>
        <source>Usual values</source>
        <translation>Typowe wartości</translation>
    </message>
</context>
<context>
    <name>lathelier::PanelBase</name>
    <message>
        <source>Open %1</source>
        <translation>Otwórz %1</translation>
    </message>
    <message>
        <source>Add to the report</source>
        <translation>Dodaj do raportu</translation>
    </message>
    <message>
        <source>Take out of the report</source>
        <translation>Usuń z raportu</translation>
    </message>
    <message>
        <source>Still missing: %1</source>
        <translation>Jeszcze brakuje: %1</translation>
    </message>
    <message>
        <source>Stopped. Change an input or press F5 to compute again.</source>
        <translation>Przerwano. Zmień dane lub naciśnij F5, aby przeliczyć ponownie.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otwórz</translation>
    </message>
    <message>
        <source>%L1 triangles</source>
        <translation>trójkąty: %L1</translation>
    </message>
    <message>
        <source>%L1 points</source>
        <translation>punkty: %L1</translation>
    </message>
    <message>
        <source>Keep “%1” in the project</source>
        <translation>Zachowaj „%1” w projekcie</translation>
    </message>
    <message>
        <source>All numbers (JSON)…</source>
        <translation>Wszystkie liczby (JSON)…</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Use what the answer proposes</source>
        <translation>Użyj propozycji odpowiedzi</translation>
    </message>
    <message>
        <source>Use as another input</source>
        <translation>Użycie jako innego wejścia</translation>
    </message>
    <message>
        <source>Input</source>
        <translation>Dane wejściowe</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Widok</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Wykryty błąd</translation>
    </message>
    <message>
        <source>Recipe for many parts (JSON)…</source>
        <translation>Receptura dla wielu części (JSON)…</translation>
    </message>
</context>
<context>
    <name>lathelier::PartsBox</name>
    <message>
        <source>Part %1</source>
        <translation>Część %1</translation>
    </message>
    <message>
        <source>%1: its data are shown</source>
        <translation>%1: pokazywane są jej dane</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Pokaż: %1</translation>
    </message>
    <message>
        <source>%1, shown</source>
        <translation>%1, pokazywana</translation>
    </message>
    <message>
        <source>Add “%1”</source>
        <translation>Dodaj „%1”</translation>
    </message>
    <message>
        <source>Remove “%1”</source>
        <translation>Usuń „%1”</translation>
    </message>
    <message>
        <source>Rename to “%1”</source>
        <translation>Zmień nazwę na „%1”</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Pokaż</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Zmień nazwę…</translation>
    </message>
    <message>
        <source>Remove from the project</source>
        <translation>Usuń z projektu</translation>
    </message>
    <message>
        <source>Add a part</source>
        <translation>Dodaj część</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Części</translation>
    </message>
    <message>
        <source>Parts of the project</source>
        <translation>Części projektu</translation>
    </message>
    <message>
        <source>Rename the part</source>
        <translation>Zmień nazwę części</translation>
    </message>
    <message>
        <source>Remove the part from the project</source>
        <translation>Usuń część z projektu</translation>
    </message>
</context>
<context>
    <name>lathelier::ProgressRow</name>
    <message>
        <source>Stopping…</source>
        <translation>Przerywanie…</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Obliczanie…</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Postęp</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Save pictures and data of this result</source>
        <translation>Zapisz obrazy i dane tego wyniku</translation>
    </message>
    <message>
        <source>In the report</source>
        <translation>W raporcie</translation>
    </message>
    <message>
        <source>Make this result part of the project&apos;s report</source>
        <translation>Włącz ten wynik do raportu projektu</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Raport</translation>
    </message>
    <message>
        <source>HTML report…</source>
        <translation>Raport HTML…</translation>
    </message>
    <message>
        <source>PDF report…</source>
        <translation>Raport PDF…</translation>
    </message>
    <message>
        <source>Write a report of this result</source>
        <translation>Zapisz raport z tego wyniku</translation>
    </message>
</context>
<context>
    <name>lathelier::ProjectFiles</name>
    <message>
        <source>Lathelier projects (*.lathelier)</source>
        <translation>Projekty Lathelier (*.lathelier)</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Zapisz projekt</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Niezapisane zmiany</translation>
    </message>
    <message>
        <source>The project has unsaved changes.</source>
        <translation>Projekt ma niezapisane zmiany.</translation>
    </message>
    <message>
        <source>Save them before going on?</source>
        <translation>Zapisać je przed dalszą pracą?</translation>
    </message>
    <message>
        <source>a project without a name</source>
        <translation>projekt bez nazwy</translation>
    </message>
    <message>
        <source>Recover unsaved work</source>
        <translation>Odzyskaj niezapisaną pracę</translation>
    </message>
    <message>
        <source>Lathelier ended unexpectedly. Unsaved work on %1 was kept.</source>
        <translation>Lathelier zakończył się nieoczekiwanie. Zachowano niezapisaną pracę: %1.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Odzyskaj</translation>
    </message>
    <message>
        <source>Throw away</source>
        <translation>Odrzuć</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>Później</translation>
    </message>
    <message>
        <source>Making the sample scans…</source>
        <translation>Tworzenie przykładowych skanów…</translation>
    </message>
    <message>
        <source>Changed elsewhere</source>
        <translation>Zmieniono gdzie indziej</translation>
    </message>
    <message>
        <source>%1 was changed by another window or program since it was opened here.</source>
        <translation>Plik %1 został zmieniony przez inne okno lub program, odkąd otwarto go tutaj.</translation>
    </message>
    <message>
        <source>Both versions stay when yours gets another name.</source>
        <translation>Obie wersje zostaną, jeśli ta otrzyma inną nazwę.</translation>
    </message>
    <message>
        <source>Save under another name…</source>
        <translation>Zapisz pod inną nazwą…</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>Zastąp</translation>
    </message>
    <message>
        <source>no files</source>
        <translation>bez plików</translation>
    </message>
    <message>
        <source>Kept on %1, with %2.</source>
        <translation>Zachowano %1, z plikami: %2.</translation>
    </message>
    <message>
        <source>Save as recipe</source>
        <translation>Zapis receptury</translation>
    </message>
</context>
<context>
    <name>lathelier::QuestionBar</name>
    <message>
        <source>Questions</source>
        <translation>Pytania</translation>
    </message>
</context>
<context>
    <name>lathelier::QuestionBox</name>
    <message>
        <source>no answer yet</source>
        <translation>jeszcze bez odpowiedzi</translation>
    </message>
    <message>
        <source>computing…</source>
        <translation>obliczanie…</translation>
    </message>
    <message>
        <source>could not be answered</source>
        <translation>nie można było odpowiedzieć</translation>
    </message>
    <message>
        <source>out of date</source>
        <translation>nieaktualne</translation>
    </message>
    <message>
        <source>≈ rests on assumed values</source>
        <translation>≈ opiera się na przyjętych wartościach</translation>
    </message>
</context>
<context>
    <name>lathelier::RowsEdit</name>
    <message>
        <source>Add a row</source>
        <translation>Dodaj wiersz</translation>
    </message>
    <message>
        <source>Remove the selected rows</source>
        <translation>Usuń zaznaczone wiersze</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Wklej</translation>
    </message>
    <message>
        <source>Paste rows from a spreadsheet, from the current cell on</source>
        <translation>Wklej wiersze z arkusza, od bieżącej komórki</translation>
    </message>
</context>
<context>
    <name>lathelier::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>Ustawienia</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Jak w systemie</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Type size in presenter mode</source>
        <translation>Wielkość pisma w trybie prezentacji</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Język</translation>
    </message>
    <message>
        <source>Presenter type size</source>
        <translation>Pismo prezentacji</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Jasny</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Ciemny</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Motyw</translation>
    </message>
    <message>
        <source>the one each panel begins with</source>
        <translation>ta, od której zaczyna panel</translation>
    </message>
    <message>
        <source>What new evaluations begin with; each can be changed</source>
        <translation>Od czego zaczynają nowe oceny; każdą można zmienić</translation>
    </message>
    <message>
        <source>Decision rule of new evaluations</source>
        <translation>Reguła decyzyjna nowych ocen</translation>
    </message>
    <message>
        <source>millimetre (mm)</source>
        <translation>milimetr (mm)</translation>
    </message>
    <message>
        <source>inch (in)</source>
        <translation>cal (in)</translation>
    </message>
    <message>
        <source>micrometre (µm)</source>
        <translation>mikrometr (µm)</translation>
    </message>
    <message>
        <source>microinch (µin)</source>
        <translation>mikrocal (µin)</translation>
    </message>
    <message>
        <source>On screen and in reports; files with numbers and the command line keep mm and µm</source>
        <translation>Na ekranie i w raportach; pliki z liczbami i wiersz poleceń zachowują mm i µm</translation>
    </message>
    <message>
        <source>Lengths and deviations in</source>
        <translation>Długości i odchyłki</translation>
    </message>
    <message>
        <source>Form and run-out in</source>
        <translation>Kształt i bicie</translation>
    </message>
</context>
<context>
    <name>lathelier::ShopDialog</name>
    <message>
        <source>Choose the shop</source>
        <translation>Wybierz warsztat</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nowa</translation>
    </message>
    <message>
        <source>An entry of your own, with the values of this one</source>
        <translation>Własna pozycja z wartościami tej</translation>
    </message>
    <message>
        <source>Takes your own entry away; one that is built in stays</source>
        <translation>Usuwa własną pozycję; wbudowana pozostaje</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Źródło</translation>
    </message>
    <message>
        <source>none</source>
        <translation>brak</translation>
    </message>
    <message>
        <source>%1 (built in, assumed)</source>
        <translation>%1 (wbudowane, przyjęte)</translation>
    </message>
    <message>
        <source>stated by the user, %1</source>
        <translation>podane przez użytkownika, %1</translation>
    </message>
    <message>
        <source>My %1</source>
        <translation>Moje: %1</translation>
    </message>
    <message>
        <source>Shop</source>
        <translation>Warsztat</translation>
    </message>
    <message>
        <source>that of the lathe</source>
        <translation>jak tokarka</translation>
    </message>
    <message>
        <source>Control</source>
        <translation>Sterowanie</translation>
    </message>
    <message>
        <source>Read…</source>
        <translation>Wczytaj…</translation>
    </message>
    <message>
        <source>Write…</source>
        <translation>Zapisz…</translation>
    </message>
    <message>
        <source>Lathe</source>
        <translation>Tokarka</translation>
    </message>
    <message>
        <source>Chuck</source>
        <translation>Uchwyt</translation>
    </message>
    <message>
        <source>Tailstock</source>
        <translation>Konik</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Materiał</translation>
    </message>
    <message>
        <source>Read a shop</source>
        <translation>Wczytaj warsztat</translation>
    </message>
    <message>
        <source>Shops (*.json)</source>
        <translation>Warsztaty (*.json)</translation>
    </message>
    <message>
        <source>Write the shop</source>
        <translation>Zapisz warsztat</translation>
    </message>
</context>
<context>
    <name>lathelier::TitleBlockDialog</name>
    <message>
        <source>Title block</source>
        <translation>Tabliczka</translation>
    </message>
    <message>
        <source>What is filled in stands on the first page of every report of this project.</source>
        <translation>Co tu wypełniono, stoi na pierwszej stronie każdego raportu tego projektu.</translation>
    </message>
    <message>
        <source>Without logo</source>
        <translation>Bez logo</translation>
    </message>
    <message>
        <source>Logo…</source>
        <translation>Logo…</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>Logo</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.svg *.bmp)</source>
        <translation>Obrazy (*.png *.jpg *.jpeg *.svg *.bmp)</translation>
    </message>
</context>
<context>
    <name>lathelier::VerifyDialog</name>
    <message>
        <source>Write the report</source>
        <translation>Zapisz raport</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Verify installation</source>
        <translation>Sprawdzenie instalacji</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Obliczanie…</translation>
    </message>
    <message>
        <source>Kinds of reference data</source>
        <translation>Rodzaje danych wzorcowych</translation>
    </message>
    <message>
        <source>Report…</source>
        <translation>Raport…</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zamknij</translation>
    </message>
    <message>
        <source>Reference data with known answers are computed on this computer. The largest deviation of each kind has to stay below its limit.</source>
        <translation>Na tym komputerze oblicza się dane odniesienia o znanych wynikach. Największa odchyłka każdego rodzaju musi być mniejsza od granicy.</translation>
    </message>
</context>
<context>
    <name>lathelier::ViewFrame</name>
    <message>
        <source>Click: enlarge. Double click: all views.</source>
        <translation>Kliknięcie powiększa. Podwójne kliknięcie: wszystkie widoki.</translation>
    </message>
</context>
<context>
    <name>lathelier::chain_panel::ChainPanel</name>
    <message>
        <source>Dossier…</source>
        <translation>Dokumentacja…</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Set-up as fitted…</source>
        <translation>Ustawienie dopasowane do kopii…</translation>
    </message>
</context>
<context>
    <name>lathelier::chain_panel::ChainRunRow</name>
    <message numerus="yes">
        <source>Run %n step(s)…</source>
        <translation>
            <numerusform>Wykonaj %n krok…</numerusform>
            <numerusform>Wykonaj %n kroki…</numerusform>
            <numerusform>Wykonaj %n kroków…</numerusform>
        </translation>
    </message>
    <message>
        <source>Up to date</source>
        <translation>Aktualny</translation>
    </message>
    <message>
        <source>Open a step of the chain</source>
        <translation>Otwórz krok łańcucha</translation>
    </message>
    <message>
        <source>Stopping…</source>
        <translation>Zatrzymywanie…</translation>
    </message>
    <message>
        <source>Write the report of the chain</source>
        <translation>Zapisz raport łańcucha</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Write the dossier</source>
        <translation>Zapisz dokumentację</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Chain from the scan to the proof of the copy</source>
        <translation>Łańcuch od skanu do dowodu kopii</translation>
    </message>
    <message>
        <source>Run the chain…</source>
        <translation>Uruchom łańcuch…</translation>
    </message>
    <message>
        <source>Runs the steps that are not made yet or out of date, after a question</source>
        <translation>Uruchamia kroki jeszcze niewykonane albo nieaktualne, po zapytaniu</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Anuluj</translation>
    </message>
    <message>
        <source>What was made before stays</source>
        <translation>To, co wykonano wcześniej, pozostaje</translation>
    </message>
    <message>
        <source>Report and dossier of the chain</source>
        <translation>Raport i dokumentacja łańcucha</translation>
    </message>
    <message>
        <source>&amp;Report…</source>
        <translation>&amp;Raport…</translation>
    </message>
    <message>
        <source>&amp;Dossier…</source>
        <translation>&amp;Dokumentacja…</translation>
    </message>
    <message>
        <source>&amp;Open the folder</source>
        <translation>&amp;Otwórz folder</translation>
    </message>
</context>
<context>
    <name>lathelier::chain_panel::ChainViews</name>
    <message>
        <source>Predicted and measured</source>
        <translation>Przewidywane i zmierzone</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Wiersze</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Dopasowanie</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Kroki</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Pliki</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>Rows with their normalized errors</source>
        <translation>Wiersze i ich błędy znormalizowane</translation>
    </message>
    <message>
        <source>Stiffness and forces fitted to the copy</source>
        <translation>Sztywność i siły dopasowane do kopii</translation>
    </message>
    <message>
        <source>Steps of the chain</source>
        <translation>Kroki łańcucha</translation>
    </message>
    <message>
        <source>Files of the chain</source>
        <translation>Pliki łańcucha</translation>
    </message>
    <message>
        <source>Numbers and where they stand</source>
        <translation>Liczby i ich położenie</translation>
    </message>
    <message>
        <source>Take the fit to the machine</source>
        <translation>Przenieś dopasowanie do maszyny</translation>
    </message>
    <message>
        <source>Stiffness and forces as fitted to the copy become a machine of the project; Deflection and the chain take them from then on. One undo step.</source>
        <translation>Sztywność i siły dopasowane do kopii stają się maszyną projektu; Ugięcie i łańcuch biorą je odtąd. Można to cofnąć jednym krokiem.</translation>
    </message>
</context>
<context>
    <name>lathelier::chain_panel::RunDialog</name>
    <message>
        <source>Run the chain</source>
        <translation>Wykonanie łańcucha</translation>
    </message>
    <message>
        <source>These steps will run; all others stay as they are:</source>
        <translation>Te kroki zostaną wykonane; pozostałe zostaną bez zmian:</translation>
    </message>
    <message>
        <source>Every step that has its files is done and up to date.</source>
        <translation>Wszystkie kroki, które mają swoje pliki, są wykonane i aktualne.</translation>
    </message>
    <message>
        <source>These lack a file and are left out:</source>
        <translation>Tym brakuje pliku i są pomijane:</translation>
    </message>
    <message>
        <source>&amp;Folder of the chain:</source>
        <translation>&amp;Folder łańcucha:</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Wybierz…</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Wykonaj</translation>
    </message>
    <message>
        <source>Folder of the chain</source>
        <translation>Folder łańcucha</translation>
    </message>
    <message>
        <source>In another folder every step runs that has its files.</source>
        <translation>W innym katalogu zostaną wykonane wszystkie kroki, które mają swoje pliki.</translation>
    </message>
</context>
<context>
    <name>lathelier::chain_panel::StepTexts</name>
    <message>
        <source>Takes (SHA-256):</source>
        <translation>Bierze (SHA-256):</translation>
    </message>
    <message>
        <source>Makes (SHA-256):</source>
        <translation>Tworzy (SHA-256):</translation>
    </message>
</context>
<context>
    <name>lathelier::chatter_common::ModelFacts</name>
    <message>
        <source>springs</source>
        <translation>sprężyny</translation>
    </message>
    <message>
        <source>table</source>
        <translation>tabela</translation>
    </message>
    <message>
        <source>%L1 segments · %2</source>
        <translation>odcinków: %L1 · %2</translation>
    </message>
    <message>
        <source>%L1 lines</source>
        <translation>%L1 linii</translation>
    </message>
    <message>
        <source>%L1 responses · %2</source>
        <translation>%L1 charakterystyk · %2</translation>
    </message>
</context>
<context>
    <name>lathelier::compare_panel::ComparePanel</name>
    <message>
        <source>Change the tolerance</source>
        <translation>Zmień tolerancję</translation>
    </message>
    <message>
        <source>Swap reference and copy</source>
        <translation>Zamień oryginał z kopią</translation>
    </message>
    <message>
        <source>Deviations of all points (CSV)…</source>
        <translation>Odchyłki wszystkich punktów (CSV)…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabela (*.csv)</translation>
    </message>
    <message>
        <source>⇅ Swap</source>
        <translation>⇅ Zamień</translation>
    </message>
    <message>
        <source>Reference and copy change places</source>
        <translation>Oryginał i kopia zamieniają się miejscami</translation>
    </message>
    <message>
        <source>%1, z %2 mm</source>
        <translation>%1, z %2 mm</translation>
    </message>
    <message>
        <source>Zone %1</source>
        <translation>Strefa %1</translation>
    </message>
    <message>
        <source>Leave a zone out</source>
        <translation>Pomiń strefę</translation>
    </message>
    <message>
        <source>Remove a zone</source>
        <translation>Usuń strefę</translation>
    </message>
    <message>
        <source>Edit a zone</source>
        <translation>Zmień strefę</translation>
    </message>
    <message>
        <source>Add a zone</source>
        <translation>Dodaj strefę</translation>
    </message>
    <message>
        <source>Show another copy</source>
        <translation>Pokaż inną kopię</translation>
    </message>
    <message>
        <source>%L1 segments · %2</source>
        <translation>odcinków: %L1 · %2</translation>
    </message>
</context>
<context>
    <name>lathelier::compare_panel::CompareViews</name>
    <message>
        <source>Reference</source>
        <translation>Oryginał</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopia</translation>
    </message>
    <message>
        <source>deviation %1</source>
        <translation>odchyłka %1</translation>
    </message>
    <message>
        <source>this point was left out</source>
        <translation>ten punkt pominięto</translation>
    </message>
    <message>
        <source>mean around it %1</source>
        <translation>średnia wokół %1</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Meridian</source>
        <translation>Zarys osiowy</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Rozkład</translation>
    </message>
    <message>
        <source>Zones</source>
        <translation>Strefy</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>Nałożenie</translation>
    </message>
    <message>
        <source>The original blue, the copy red</source>
        <translation>Oryginał niebieski, kopia czerwona</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Odchyłka</translation>
    </message>
    <message>
        <source>The copy, coloured by its distance from the original&apos;s surface</source>
        <translation>Kopia w barwach odległości od powierzchni oryginału</translation>
    </message>
    <message>
        <source>Local mean</source>
        <translation>Średnia lokalna</translation>
    </message>
    <message>
        <source>Error ×</source>
        <translation>Błąd ×</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
    <message>
        <source>These scans were computed, not measured.</source>
        <translation>Te skany obliczono, nie zmierzono.</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Część</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabele</translation>
    </message>
    <message>
        <source>How many times larger part and meridian draw the deviation</source>
        <translation>Ile razy większą odchyłkę rysują część i zarys osiowy</translation>
    </message>
    <message>
        <source>Roundness here</source>
        <translation>Okrągłość tutaj</translation>
    </message>
    <message>
        <source>Cuts the marked section out of the copy and opens it in the panel Roundness</source>
        <translation>Wycina zaznaczony przekrój z kopii i otwiera go w panelu Okrągłość</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Kształt</translation>
    </message>
    <message>
        <source>Colours of the error: red too large, blue too small</source>
        <translation>Barwy błędu: czerwona za dużo, niebieska za mało</translation>
    </message>
    <message>
        <source>Pass/fail</source>
        <translation>Ocena</translation>
    </message>
    <message>
        <source>Green within the tolerance, red above it, blue below it</source>
        <translation>Zielona w tolerancji, czerwona powyżej, niebieska poniżej</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>pominięto</translation>
    </message>
    <message>
        <source>Each place has the mean of its surroundings, as large as it needs to be sure; grey: not sure; off: every point by itself</source>
        <translation>Każde miejsce ma średnią otoczenia tak dużego, by była pewna; szare: niepewna; wyłączone: każdy punkt osobno</translation>
    </message>
    <message>
        <source>Zone</source>
        <translation>Strefa</translation>
    </message>
    <message>
        <source>Draw a zone with limits of its own: drag along the axis in the map, the deviation or the meridian. On a zone that is there: edit it.</source>
        <translation>Narysuj strefę z własnymi granicami: przeciągnij wzdłuż osi na mapie, odchyłce lub zarysie. Na istniejącej strefie: zmień ją.</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>Kopie</translation>
    </message>
    <message>
        <source>Double click: show this copy</source>
        <translation>Podwójne kliknięcie: pokaż tę kopię</translation>
    </message>
    <message>
        <source>along the axis %1, angle %2°</source>
        <translation>wzdłuż osi %1, kąt %2°</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Wymiary</translation>
    </message>
    <message>
        <source>%1 (limit %2)</source>
        <translation>%1 (granica %2)</translation>
    </message>
</context>
<context>
    <name>lathelier::compare_panel::StatisticsTable</name>
    <message>
        <source>Statistics</source>
        <translation>Statystyka</translation>
    </message>
</context>
<context>
    <name>lathelier::compare_panel::ZoneDialog</name>
    <message>
        <source>Zone</source>
        <translation>Strefa</translation>
    </message>
    <message>
        <source>New zone</source>
        <translation>Nowa strefa</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Pomiń</translation>
    </message>
    <message>
        <source>The zone has to end beyond its start.</source>
        <translation>Strefa musi kończyć się za swoim początkiem.</translation>
    </message>
    <message>
        <source>Give both limits, or none.</source>
        <translation>Podaj obie granice albo żadnej.</translation>
    </message>
    <message>
        <source>The upper limit has to be above the lower one.</source>
        <translation>Górna granica musi być większa od dolnej.</translation>
    </message>
</context>
<context>
    <name>lathelier::compare_panel::ZoneTable</name>
    <message>
        <source>Zones along the axis</source>
        <translation>Strefy wzdłuż osi</translation>
    </message>
    <message>
        <source>Standard deviation of the single points in the zone</source>
        <translation>Odchylenie standardowe pojedynczych punktów w strefie</translation>
    </message>
    <message>
        <source>Expanded uncertainty of the mean (k = 2)</source>
        <translation>Niepewność rozszerzona średniej (k = 2)</translation>
    </message>
</context>
<context>
    <name>lathelier::correction_panel::CorrectionPanel</name>
    <message>
        <source>Correct line %1</source>
        <translation>Koryguj wiersz %1</translation>
    </message>
    <message>
        <source>Keep line %1</source>
        <translation>Zostaw wiersz %1</translation>
    </message>
</context>
<context>
    <name>lathelier::correction_panel::CorrectionViews</name>
    <message>
        <source>Programs side by side</source>
        <translation>Programy obok siebie</translation>
    </message>
    <message>
        <source>Correction</source>
        <translation>Korekcja</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Przed i po</translation>
    </message>
    <message>
        <source>Other machines</source>
        <translation>Inne maszyny</translation>
    </message>
    <message>
        <source>Changed blocks only</source>
        <translation>Tylko zmienione bloki</translation>
    </message>
    <message>
        <source>Check as a turning program</source>
        <translation>Sprawdź jako program tokarski</translation>
    </message>
    <message>
        <source>Gives the corrected program with its correction to the panel Turning program, which checks it against the drawing, the stock and the chuck.</source>
        <translation>Daje skorygowany program wraz z korekcją panelowi Program tokarski, który sprawdza go względem rysunku, materiału i uchwytu.</translation>
    </message>
</context>
<context>
    <name>lathelier::correction_panel::DiffModel</name>
    <message>
        <source>kept as it was</source>
        <translation>zostaje, jak był</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Bierz</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Wiersz</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <source>Corrected</source>
        <translation>Skorygowany</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Powód</translation>
    </message>
</context>
<context>
    <name>lathelier::cylindricity_panel::CylindricityPanel</name>
    <message>
        <source>%1, z %2 mm</source>
        <translation>%1, z %2 mm</translation>
    </message>
</context>
<context>
    <name>lathelier::cylindricity_panel::CylindricityViews</name>
    <message>
        <source>Error drawn × %1</source>
        <translation>Błąd narysowany × %1</translation>
    </message>
    <message>
        <source>deviation %1</source>
        <translation>odchyłka %1</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Część</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>Local radius</source>
        <translation>Promień miejscowy</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Oś</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
    <message>
        <source>These points were computed, not measured.</source>
        <translation>Te punkty obliczono, nie zmierzono.</translation>
    </message>
    <message>
        <source>Roundness of this section</source>
        <translation>Okrągłość tego przekroju</translation>
    </message>
    <message>
        <source>Cuts the marked section out of the points and opens it in the panel Roundness</source>
        <translation>Wycina zaznaczony przekrój z punktów i otwiera go w panelu Okrągłość</translation>
    </message>
    <message>
        <source>along the axis %1, angle %2°</source>
        <translation>wzdłuż osi %1, kąt %2°</translation>
    </message>
</context>
<context>
    <name>lathelier::deflection_common::TurningFacts</name>
    <message>
        <source>chuck and tailstock</source>
        <translation>uchwyt i konik</translation>
    </message>
    <message>
        <source>chuck</source>
        <translation>uchwyt</translation>
    </message>
    <message>
        <source>%L1 blocks</source>
        <translation>bloki: %L1</translation>
    </message>
</context>
<context>
    <name>lathelier::deflection_panel::DeflectionViews</name>
    <message>
        <source>Forces</source>
        <translation>Siły</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Głębokość</translation>
    </message>
    <message>
        <source>Power</source>
        <translation>Moc</translation>
    </message>
    <message>
        <source>Depth and feed</source>
        <translation>Głębokość i posuw</translation>
    </message>
    <message>
        <source>Sensitivities</source>
        <translation>Wrażliwości</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Zmierzone</translation>
    </message>
    <message>
        <source>Measured diameters</source>
        <translation>Zmierzone średnice</translation>
    </message>
    <message>
        <source>Stock after each pass</source>
        <translation>Półfabrykat po każdym przejściu</translation>
    </message>
    <message>
        <source>What the tool meets</source>
        <translation>Co trafia narzędzie</translation>
    </message>
    <message>
        <source>Compliance</source>
        <translation>Podatność</translation>
    </message>
    <message>
        <source>Feed along z</source>
        <translation>Posuw wzdłuż z</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Przedmiot</translation>
    </message>
    <message>
        <source>Bend drawn × %1 while the tool cuts at z %2</source>
        <translation>Ugięcie narysowane × %1, gdy narzędzie skrawa przy z %2</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>narzędzie</translation>
    </message>
    <message>
        <source>Bent work and its error</source>
        <translation>Ugięty przedmiot i jego błąd</translation>
    </message>
    <message>
        <source>Bent axis</source>
        <translation>Ugięta oś</translation>
    </message>
</context>
<context>
    <name>lathelier::drawing_panel::DimensionEdit</name>
    <message>
        <source>Diameter in mm</source>
        <translation>Średnica w mm</translation>
    </message>
    <message>
        <source>Length in mm</source>
        <translation>Długość w mm</translation>
    </message>
    <message>
        <source>Radius in mm</source>
        <translation>Promień w mm</translation>
    </message>
    <message>
        <source>Leg in mm × angle in degrees; the leg alone keeps the angle</source>
        <translation>Bok w mm × kąt w stopniach; sam bok zachowuje kąt</translation>
    </message>
    <message>
        <source>Width × diameter of the bottom in mm; the width alone keeps it</source>
        <translation>Szerokość × średnica dna w mm; sama szerokość zachowuje dno</translation>
    </message>
    <message>
        <source>1:10, or the whole angle in degrees</source>
        <translation>1:10 albo cały kąt w stopniach</translation>
    </message>
    <message>
        <source>Dimension</source>
        <translation>Wymiar</translation>
    </message>
    <message>
        <source>Change the diameter of row %1</source>
        <translation>Zmiana średnicy wiersza %1</translation>
    </message>
    <message>
        <source>Change a length</source>
        <translation>Zmiana długości</translation>
    </message>
    <message>
        <source>Change the radius of row %1</source>
        <translation>Zmiana promienia wiersza %1</translation>
    </message>
    <message>
        <source>Change the chamfer of row %1</source>
        <translation>Zmiana fazy wiersza %1</translation>
    </message>
    <message>
        <source>Change the groove of row %1</source>
        <translation>Zmiana rowka wiersza %1</translation>
    </message>
    <message>
        <source>Change the angle of row %1</source>
        <translation>Zmiana kąta wiersza %1</translation>
    </message>
</context>
<context>
    <name>lathelier::drawing_panel::DrawingPanel</name>
    <message>
        <source>%L1 segments · %2</source>
        <translation>odcinków: %L1 · %2</translation>
    </message>
    <message>
        <source>Drawing (PDF)…</source>
        <translation>Rysunek (PDF)…</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>Dokument (*.pdf)</translation>
    </message>
</context>
<context>
    <name>lathelier::drawing_panel::DrawingViews</name>
    <message>
        <source>Drawing</source>
        <translation>Rysunek</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Wiersze</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>Use this shaft</source>
        <translation>Użyj tego wału</translation>
    </message>
    <message>
        <source>Keep it in the project, where other panels take it as an input</source>
        <translation>Zachowuje go w projekcie, skąd biorą go inne panele</translation>
    </message>
    <message>
        <source>Whole sheet</source>
        <translation>Cały arkusz</translation>
    </message>
    <message>
        <source>Delete row %1</source>
        <translation>Usuń wiersz %1</translation>
    </message>
    <message>
        <source>Merge rows %1 and %2</source>
        <translation>Połączenie wierszy %1 i %2</translation>
    </message>
    <message>
        <source>Split row %1</source>
        <translation>Podział wiersza %1</translation>
    </message>
    <message>
        <source>Make row %1 a %2</source>
        <translation>Wiersz %1 jako: %2</translation>
    </message>
    <message>
        <source>row %1, ⌀ %2</source>
        <translation>wiersz %1, ⌀ %2</translation>
    </message>
    <message>
        <source>Row %1 as wide as row %2</source>
        <translation>Wiersz %1 tak szeroki jak wiersz %2</translation>
    </message>
    <message>
        <source>Free the diameter of row %1</source>
        <translation>Uwolnienie średnicy wiersza %1</translation>
    </message>
    <message>
        <source>Move the shoulder behind row %1</source>
        <translation>Przesunięcie odsadzenia za wierszem %1</translation>
    </message>
    <message>
        <source>Meridian</source>
        <translation>Zarys osiowy</translation>
    </message>
    <message>
        <source>Measured − nominal</source>
        <translation>Zmierzone − nominalne</translation>
    </message>
    <message>
        <source>The wheel enlarges the drawing, dragging moves it. A click lights a row, a double click on a dimension changes it, the right button shows what can be done with a row.</source>
        <translation>Kółko myszy powiększa rysunek, przeciąganie go przesuwa. Kliknięcie podświetla wiersz, podwójne kliknięcie wymiaru zmienia go, prawy przycisk pokazuje, co można zrobić z wierszem.</translation>
    </message>
    <message>
        <source>Add a bore</source>
        <translation>Dodaj otwór</translation>
    </message>
    <message>
        <source>A cylinder from this end, or one more behind the last one. Its row in the table is changed by a double click, its kind and its place by the right button.</source>
        <translation>Walec od tego końca albo kolejny za ostatnim. Jego wiersz w tabeli zmienia podwójne kliknięcie, rodzaj i miejsce – prawy przycisk.</translation>
    </message>
    <message>
        <source>From the free end</source>
        <translation>Od wolnego końca</translation>
    </message>
    <message>
        <source>From the chuck end</source>
        <translation>Od strony uchwytu</translation>
    </message>
    <message>
        <source>Change row %1</source>
        <translation>Zmień wiersz %1</translation>
    </message>
    <message>
        <source>Row %1</source>
        <translation>Wiersz %1</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Add a row behind it</source>
        <translation>Dodaj wiersz za nim</translation>
    </message>
    <message>
        <source>Add a row behind %1</source>
        <translation>Dodaj wiersz za %1</translation>
    </message>
    <message>
        <source>Change its kind</source>
        <translation>Zmień rodzaj</translation>
    </message>
    <message>
        <source>Add a bore from the free end</source>
        <translation>Dodaj otwór od wolnego końca</translation>
    </message>
    <message>
        <source>Add a bore from the chuck end</source>
        <translation>Dodaj otwór od strony uchwytu</translation>
    </message>
    <message>
        <source>Change the diameter of a bore</source>
        <translation>Zmień średnicę otworu</translation>
    </message>
    <message>
        <source>Change the depth of a bore</source>
        <translation>Zmień głębokość otworu</translation>
    </message>
    <message>
        <source>The bores already run through the whole part</source>
        <translation>Otwory przechodzą już przez całą część</translation>
    </message>
</context>
<context>
    <name>lathelier::drawing_panel::SheetView</name>
    <message>
        <source>A double click opens a field for another size</source>
        <translation>Podwójne kliknięcie otwiera pole na inny wymiar</translation>
    </message>
</context>
<context>
    <name>lathelier::frf_panel::FrfPanel</name>
    <message>
        <source>Drag a peak</source>
        <translation>Przeciągnij szczyt</translation>
    </message>
    <message>
        <source>Back to the fit</source>
        <translation>Powrót do dopasowania</translation>
    </message>
</context>
<context>
    <name>lathelier::frf_panel::FrfViews</name>
    <message>
        <source>Magnitude</source>
        <translation>Moduł</translation>
    </message>
    <message>
        <source>Modes</source>
        <translation>Postacie</translation>
    </message>
    <message>
        <source>Real part</source>
        <translation>Część rzeczywista</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Faza</translation>
    </message>
    <message>
        <source>Nyquist</source>
        <translation>Nyquist</translation>
    </message>
    <message>
        <source>Imaginary part</source>
        <translation>Część urojona</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Koherencja</translation>
    </message>
    <message>
        <source>Error of the model</source>
        <translation>Błąd modelu</translation>
    </message>
    <message>
        <source>Use this response</source>
        <translation>Użyj tej charakterystyki</translation>
    </message>
    <message>
        <source>Lobes of this response: as measured, or of its modal model (Use for lobes)</source>
        <translation>Krzywe workowe tej charakterystyki: zmierzonej albo jej modelu modalnego (Do krzywych workowych)</translation>
    </message>
    <message>
        <source>Back to the fit</source>
        <translation>Powrót do dopasowania</translation>
    </message>
    <message>
        <source>Takes the modes of the fit again in place of those changed by hand</source>
        <translation>Przyjmuje znów postacie dopasowane zamiast zmienionych ręcznie</translation>
    </message>
    <message>
        <source>Stability of the poles</source>
        <translation>Stabilność biegunów</translation>
    </message>
    <message>
        <source>All responses</source>
        <translation>Wszystkie charakterystyki</translation>
    </message>
</context>
<context>
    <name>lathelier::lobes_panel::LobesPanel</name>
    <message>
        <source>Move the operating point</source>
        <translation>Przesunięcie punktu pracy</translation>
    </message>
</context>
<context>
    <name>lathelier::lobes_panel::LobesViews</name>
    <message>
        <source>Lobes</source>
        <translation>Worki</translation>
    </message>
    <message>
        <source>Real and imaginary</source>
        <translation>Rzeczywista i urojona</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Amplituda</translation>
    </message>
    <message>
        <source>Chatter frequency</source>
        <translation>Częstotliwość drgań</translation>
    </message>
    <message>
        <source>Stable speeds</source>
        <translation>Prędkości stabilne</translation>
    </message>
    <message>
        <source>Double click: work at this speed</source>
        <translation>Dwukrotne kliknięcie: pracuj z tą prędkością</translation>
    </message>
    <message>
        <source>Work</source>
        <translation>Przedmiot</translation>
    </message>
    <message>
        <source>Chatter at %1 under a force at z %2; the amplitude is drawn large</source>
        <translation>Drgania samowzbudne przy %1 pod siłą w z %2; amplituda narysowana w powiększeniu</translation>
    </message>
    <message>
        <source>How the work swings</source>
        <translation>Jak drga przedmiot</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Drgania</translation>
    </message>
    <message>
        <source>Let the work swing as it chatters</source>
        <translation>Pokaż, jak przedmiot drga samowzbudnie</translation>
    </message>
</context>
<context>
    <name>lathelier::longitudinal_panel::LongitudinalViews</name>
    <message>
        <source>Surface of all sections</source>
        <translation>Powierzchnia wszystkich przekrojów</translation>
    </message>
    <message>
        <source>Take out where each section lies and how large it is: what is left is its roundness</source>
        <translation>Bez położenia i wymiaru przekrojów: zostaje sama okrągłość</translation>
    </message>
    <message>
        <source>How many times larger the surface draws the deviation</source>
        <translation>Ile razy powiększono odchyłkę na powierzchni</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
    <message>
        <source>Form</source>
        <translation>Kształt</translation>
    </message>
    <message>
        <source>Along the axis</source>
        <translation>Wzdłuż osi</translation>
    </message>
    <message>
        <source>Sections</source>
        <translation>Przekroje</translation>
    </message>
    <message>
        <source>Error ×</source>
        <translation>Błąd ×</translation>
    </message>
    <message>
        <source>section %1, angle %2°
deviation %3</source>
        <translation>przekrój %1, kąt %2°
odchyłka %3</translation>
    </message>
    <message>
        <source>form only</source>
        <translation>tylko kształt</translation>
    </message>
</context>
<context>
    <name>lathelier::longitudinal_panel::SectionTable</name>
    <message>
        <source>All sections against the tolerance</source>
        <translation>Wszystkie przekroje względem tolerancji</translation>
    </message>
    <message>
        <source>Largest minus smallest radius about the spindle axis: the paper&apos;s value</source>
        <translation>Największy minus najmniejszy promień względem osi wrzeciona: wartość z artykułu</translation>
    </message>
    <message>
        <source>Referenced to the nominal diameter</source>
        <translation>Odniesiona do średnicy nominalnej</translation>
    </message>
    <message>
        <source>Two-point range: largest minus smallest distance of opposite points; half of it: GOST</source>
        <translation>Rozstęp dwupunktowy: największa minus najmniejsza odległość przeciwległych punktów; połowa z tego: GOST</translation>
    </message>
</context>
<context>
    <name>lathelier::machine_panel::MachinePanel</name>
    <message>
        <source>%L1 rods, %L2 responses</source>
        <translation>Prętów: %L1, charakterystyk: %L2</translation>
    </message>
</context>
<context>
    <name>lathelier::machine_panel::MachineViews</name>
    <message>
        <source>Magnitude</source>
        <translation>Moduł</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Faza</translation>
    </message>
    <message>
        <source>Rod held out</source>
        <translation>Pręt odłożony</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>Reszta</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Uwarunkowanie</translation>
    </message>
    <message>
        <source>Responses</source>
        <translation>Charakterystyki</translation>
    </message>
    <message>
        <source>Use this spindle</source>
        <translation>Użyj tego wrzeciona</translation>
    </message>
    <message>
        <source>Put a shaft on it</source>
        <translation>Osadź na nim wał</translation>
    </message>
</context>
<context>
    <name>lathelier::part_common::RowMenu</name>
    <message>
        <source>Cylinder</source>
        <translation>Walec</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>Stożek</translation>
    </message>
    <message>
        <source>Chamfer</source>
        <translation>Faza</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>Zaokrąglenie wypukłe</translation>
    </message>
    <message>
        <source>Fillet</source>
        <translation>Zaokrąglenie wklęsłe</translation>
    </message>
    <message>
        <source>Groove</source>
        <translation>Rowek</translation>
    </message>
    <message>
        <source>Row %1</source>
        <translation>Wiersz %1</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Usuń</translation>
    </message>
    <message>
        <source>Merge with the next</source>
        <translation>Połącz z następnym</translation>
    </message>
    <message>
        <source>Split here</source>
        <translation>Podziel tutaj</translation>
    </message>
    <message>
        <source>Change its kind</source>
        <translation>Zmień rodzaj</translation>
    </message>
    <message>
        <source>Same diameter as</source>
        <translation>Ta sama średnica co</translation>
    </message>
    <message>
        <source>Free its diameter</source>
        <translation>Uwolnij średnicę</translation>
    </message>
</context>
<context>
    <name>lathelier::pass_panel::PassPanel</name>
    <message>
        <source>Move the operating point</source>
        <translation>Przesuń punkt pracy</translation>
    </message>
</context>
<context>
    <name>lathelier::pass_panel::PassViews</name>
    <message>
        <source>Least limit</source>
        <translation>Najmniejsza granica</translation>
    </message>
    <message>
        <source>Along the pass</source>
        <translation>Wzdłuż przejścia</translation>
    </message>
    <message>
        <source>Stations</source>
        <translation>Stacje</translation>
    </message>
</context>
<context>
    <name>lathelier::plot::ChartView</name>
    <message>
        <source>radius vector %1 %2</source>
        <translation>promień wodzący %1 %2</translation>
    </message>
</context>
<context>
    <name>lathelier::plot::LimitEdit</name>
    <message>
        <source>Each side of the scale by itself</source>
        <translation>Każda strona skali osobno</translation>
    </message>
    <message>
        <source>Upper end of the colour scale in %1</source>
        <translation>Górny koniec skali barw w %1</translation>
    </message>
    <message>
        <source>The colour scale runs from minus to plus this many %1.</source>
        <translation>Skala barw biegnie od minus do plus tej wartości w %1.</translation>
    </message>
    <message>
        <source>Limit of the colour scale in %1</source>
        <translation>Granica skali barw w %1</translation>
    </message>
    <message>
        <source>How far below 0 the colour scale goes, in %1</source>
        <translation>Jak daleko poniżej 0 sięga skala barw, w %1</translation>
    </message>
</context>
<context>
    <name>lathelier::plot::MapView</name>
    <message>
        <source>no data</source>
        <translation>brak danych</translation>
    </message>
</context>
<context>
    <name>lathelier::plot::PlotWidget</name>
    <message>
        <source>Copy picture</source>
        <translation>Kopiuj obraz</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Zapisz obraz…</translation>
    </message>
    <message>
        <source>Save data as CSV…</source>
        <translation>Zapisz dane jako CSV…</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Pokaż wszystko</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Zapisz obraz</translation>
    </message>
    <message>
        <source>Scalable picture (*.svg);;PDF (*.pdf);;Picture (*.png)</source>
        <translation>Obraz skalowalny (*.svg);;PDF (*.pdf);;Obraz (*.png)</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>Zapisz dane</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabela (*.csv)</translation>
    </message>
</context>
<context>
    <name>lathelier::plot::PolarView</name>
    <message>
        <source>Take the mark away</source>
        <translation>Usuń znacznik</translation>
    </message>
</context>
<context>
    <name>lathelier::plot::PolarWords</name>
    <message>
        <source>outer contact</source>
        <translation>styk zewnętrzny</translation>
    </message>
    <message>
        <source>inner contact</source>
        <translation>styk wewnętrzny</translation>
    </message>
    <message>
        <source>deviation × %1 · %2</source>
        <translation>odchyłka × %1 · %2</translation>
    </message>
    <message>
        <source>%1, inner circle</source>
        <translation>%1, okrąg wewnętrzny</translation>
    </message>
    <message>
        <source>%1, outer circle</source>
        <translation>%1, okrąg zewnętrzny</translation>
    </message>
    <message>
        <source>%1 %2/div</source>
        <translation>%1 %2/dz.</translation>
    </message>
</context>
<context>
    <name>lathelier::program_panel::ProgramPanel</name>
    <message>
        <source>Discard the changes of the program</source>
        <translation>Odrzuć zmiany programu</translation>
    </message>
    <message>
        <source>Edit the program</source>
        <translation>Zmień program</translation>
    </message>
    <message>
        <source>Save the program</source>
        <translation>Zapisz program</translation>
    </message>
    <message>
        <source>NC program (*.nc *.ngc *.mpf *.tap);;All files (*)</source>
        <translation>Program NC (*.nc *.ngc *.mpf *.tap);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>%1 changed</source>
        <translation>%1 zmieniony</translation>
    </message>
    <message>
        <source>Program as it stands here…</source>
        <translation>Program w obecnej postaci…</translation>
    </message>
    <message>
        <source>NC program (*.nc *.ngc *.mpf *.tap)</source>
        <translation>Program NC (*.nc *.ngc *.mpf *.tap)</translation>
    </message>
</context>
<context>
    <name>lathelier::program_panel::ProgramViews</name>
    <message>
        <source>changed, not saved</source>
        <translation>zmieniony, niezapisany</translation>
    </message>
    <message>
        <source>as on the disk</source>
        <translation>jak na dysku</translation>
    </message>
    <message>
        <source>Line %1: no move</source>
        <translation>Wiersz %1: bez ruchu</translation>
    </message>
    <message>
        <source>Line %1: %2 to Ø %3, Z %4 · tool %5</source>
        <translation>Wiersz %1: %2 do Ø %3, Z %4 · narzędzie %5</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>ruch szybki</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>posuw</translation>
    </message>
    <message>
        <source>Find in the program</source>
        <translation>Szukaj w programie</translation>
    </message>
    <message>
        <source>Not found</source>
        <translation>Nie znaleziono</translation>
    </message>
    <message>
        <source>Program and path</source>
        <translation>Program i tor</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Uwagi</translation>
    </message>
    <message>
        <source>Passes</source>
        <translation>Przejścia</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>Szukaj</translation>
    </message>
    <message>
        <source>Find the one before</source>
        <translation>Znajdź poprzednie</translation>
    </message>
    <message>
        <source>Find the next one</source>
        <translation>Znajdź następne</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Zapisz jako…</translation>
    </message>
    <message>
        <source>Save the program as a new file</source>
        <translation>Zapisz program jako nowy plik</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Odrzuć zmiany</translation>
    </message>
    <message>
        <source>Take the program of the file again</source>
        <translation>Weź znów program z pliku</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Tekst programu</translation>
    </message>
    <message>
        <source>Path of the tool</source>
        <translation>Tor narzędzia</translation>
    </message>
</context>
<context>
    <name>lathelier::recognise_panel::RecognisePanel</name>
    <message>
        <source>Take back the size of row %1</source>
        <translation>Cofnij wymiar wiersza %1</translation>
    </message>
    <message>
        <source>Accept the size of row %1</source>
        <translation>Przyjmij wymiar wiersza %1</translation>
    </message>
    <message>
        <source>Accept all nominal sizes</source>
        <translation>Przyjmij wszystkie wymiary nominalne</translation>
    </message>
    <message>
        <source>Take back all changes of the rows</source>
        <translation>Cofnij wszystkie zmiany wierszy</translation>
    </message>
    <message>
        <source>Drawing (PDF)…</source>
        <translation>Rysunek (PDF)…</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>Dokument (*.pdf)</translation>
    </message>
</context>
<context>
    <name>lathelier::recognise_panel::RecogniseViews</name>
    <message>
        <source>row %1: %2, z %3-%4</source>
        <translation>wiersz %1: %2, z %3-%4</translation>
    </message>
    <message>
        <source>All rows are in this table.</source>
        <translation>Wszystkie wiersze są w tej tabeli.</translation>
    </message>
    <message>
        <source>Not in this table: %1</source>
        <translation>Nie ma w tej tabeli: %1</translation>
    </message>
    <message>
        <source>on no row</source>
        <translation>na żadnym wierszu</translation>
    </message>
    <message>
        <source>row %1: ⌀ %2</source>
        <translation>wiersz %1: ⌀ %2</translation>
    </message>
    <message>
        <source>Meridian</source>
        <translation>Zarys osiowy</translation>
    </message>
    <message>
        <source>Rows</source>
        <translation>Wiersze</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Część</translation>
    </message>
    <message>
        <source>Table as published</source>
        <translation>Tabela jak w publikacji</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
    <message>
        <source>These points were computed, not measured.</source>
        <translation>Te punkty obliczono, nie zmierzono.</translation>
    </message>
    <message>
        <source>Use this shaft</source>
        <translation>Użyj tego wału</translation>
    </message>
    <message>
        <source>Keep it in the project, where other panels take it as an input</source>
        <translation>Zachowuje go w projekcie, skąd biorą go inne panele</translation>
    </message>
    <message>
        <source>Delete row %1</source>
        <translation>Usuń wiersz %1</translation>
    </message>
    <message>
        <source>Merge rows %1 and %2</source>
        <translation>Połączenie wierszy %1 i %2</translation>
    </message>
    <message>
        <source>Split row %1</source>
        <translation>Podział wiersza %1</translation>
    </message>
    <message>
        <source>Make row %1 a %2</source>
        <translation>Wiersz %1 jako: %2</translation>
    </message>
    <message>
        <source>As recognised</source>
        <translation>Jak rozpoznano</translation>
    </message>
    <message>
        <source>Takes back all changes of the rows</source>
        <translation>Cofa wszystkie zmiany wierszy</translation>
    </message>
</context>
<context>
    <name>lathelier::recognise_panel::RowsView</name>
    <message>
        <source>Rows</source>
        <translation>Wiersze</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>Przyjmij</translation>
    </message>
    <message>
        <source>Put the suggested size of this row in place of the measured one</source>
        <translation>Wstaw proponowany wymiar tego wiersza w miejsce zmierzonego</translation>
    </message>
    <message>
        <source>Accept all</source>
        <translation>Przyjmij wszystkie</translation>
    </message>
    <message>
        <source>Put %1 in place of the measured size.</source>
        <translation>Wstaw %1 w miejsce zmierzonego wymiaru.</translation>
    </message>
    <message>
        <source>The measured size is further from it than its U: only you can confirm it.</source>
        <translation>Zmierzony wymiar jest dalej od niego niż jego U: tylko Ty możesz go potwierdzić.</translation>
    </message>
    <message>
        <source>That any size is as near to such a number: %1 %</source>
        <translation>Że dowolny wymiar leży tak blisko takiej liczby: %1 %</translation>
    </message>
    <message>
        <source>Put all suggested sizes that the measured ones agree with within U in their place; the measured ones stay beside them</source>
        <translation>Wstaw wszystkie proponowane wymiary, z którymi zmierzone zgadzają się w granicach U; zmierzone stoją obok nich</translation>
    </message>
</context>
<context>
    <name>lathelier::roundness_panel::RoundnessPanel</name>
    <message>
        <source>Profile and circles as drawn (CSV)…</source>
        <translation>Profil i okręgi jak na wykresie (CSV)…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabela (*.csv)</translation>
    </message>
    <message>
        <source>section %1 of %2</source>
        <translation>przekrój %1 z %2</translation>
    </message>
</context>
<context>
    <name>lathelier::roundness_panel::RoundnessViews</name>
    <message>
        <source>Roundness</source>
        <translation>Okrągłość</translation>
    </message>
    <message>
        <source>The profile with its reference circles</source>
        <translation>Profil z okręgami odniesienia</translation>
    </message>
    <message>
        <source>Laid over</source>
        <translation>Nałożone</translation>
    </message>
    <message>
        <source>The profile and the trace over each other, and their difference</source>
        <translation>Profil i wykres nałożone na siebie oraz ich różnica</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
    <message>
        <source>Circles</source>
        <translation>Okręgi</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Metody</translation>
    </message>
    <message>
        <source>Undulations</source>
        <translation>Falistości</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>Roundness plot</source>
        <translation>Wykres okrągłości</translation>
    </message>
    <message>
        <source>Harmonic content</source>
        <translation>Zawartość harmonicznych</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabele</translation>
    </message>
    <message>
        <source>largest difference %1, mean %2</source>
        <translation>największa różnica %1, średnia %2</translation>
    </message>
</context>
<context>
    <name>lathelier::scene::SceneBar</name>
    <message>
        <source>Oblique</source>
        <translation>Ukośnie</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Z boku</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Z góry</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Od czoła</translation>
    </message>
    <message>
        <source>Parallel</source>
        <translation>Równolegle</translation>
    </message>
    <message>
        <source>Parallel projection: equal lengths look equal at any distance</source>
        <translation>Rzut równoległy: równe długości wyglądają tak samo z każdej odległości</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>Całość</translation>
    </message>
    <message>
        <source>Cut along X</source>
        <translation>Przekrój wzdłuż X</translation>
    </message>
    <message>
        <source>Cut along Y</source>
        <translation>Przekrój wzdłuż Y</translation>
    </message>
    <message>
        <source>Cut along Z</source>
        <translation>Przekrój wzdłuż Z</translation>
    </message>
    <message>
        <source>Cut away one side of the part</source>
        <translation>Odetnij jedną stronę części</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Przekrój</translation>
    </message>
    <message>
        <source>Place of the section</source>
        <translation>Miejsce przekroju</translation>
    </message>
</context>
<context>
    <name>lathelier::scene::SceneRuler</name>
    <message>
        <source>Directions and length scale</source>
        <translation>Kierunki i podziałka długości</translation>
    </message>
</context>
<context>
    <name>lathelier::scene::SceneView</name>
    <message>
        <source>The 3-D view needs OpenGL, which is not available here.
All other views work.</source>
        <translation>Widok 3D wymaga OpenGL, który nie jest tu dostępny.
Wszystkie inne widoki działają.</translation>
    </message>
    <message>
        <source>3-D view</source>
        <translation>Widok 3D</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Kopiuj obraz</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Zapisz obraz…</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Zapisz obraz</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Obraz (*.png)</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Pokaż całość</translation>
    </message>
</context>
<context>
    <name>lathelier::series_panel::SeriesPanel</name>
    <message>
        <source>Choose a part</source>
        <translation>Wybór części</translation>
    </message>
    <message>
        <source>Choose a characteristic</source>
        <translation>Wybór cechy</translation>
    </message>
    <message>
        <source>Open an archived evaluation</source>
        <translation>Otwarcie oceny z archiwum</translation>
    </message>
</context>
<context>
    <name>lathelier::series_panel::SeriesViews</name>
    <message>
        <source>Its files are not there any more, or were changed; the numbers are those of then.</source>
        <translation>Jej pliki już nie istnieją albo zostały zmienione; liczby są tymi z tamtego dnia.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>W czasie</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Odchyłki</translation>
    </message>
    <message>
        <source>Part in detail</source>
        <translation>Część w szczegółach</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Wartości</translation>
    </message>
    <message>
        <source>Characteristics</source>
        <translation>Cechy</translation>
    </message>
    <message>
        <source>Deviation pictures of the latest parts</source>
        <translation>Obrazy odchyłek ostatnich części</translation>
    </message>
    <message>
        <source>Characteristics of the part</source>
        <translation>Cechy części</translation>
    </message>
    <message>
        <source>Open this evaluation</source>
        <translation>Otwórz tę ocenę</translation>
    </message>
</context>
<context>
    <name>lathelier::shaft_panel::ShaftPanel</name>
    <message>
        <source>Move the end of segment %1</source>
        <translation>Przesuń koniec odcinka %1</translation>
    </message>
</context>
<context>
    <name>lathelier::shaft_panel::ShaftViews</name>
    <message>
        <source>Shaft</source>
        <translation>Wał</translation>
    </message>
    <message>
        <source>Mode shapes</source>
        <translation>Postacie drgań</translation>
    </message>
    <message>
        <source>Magnitude</source>
        <translation>Moduł</translation>
    </message>
    <message>
        <source>Real and imaginary</source>
        <translation>Część rzeczywista i urojona</translation>
    </message>
    <message>
        <source>Natural frequencies</source>
        <translation>Częstotliwości własne</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Drgaj</translation>
    </message>
    <message>
        <source>Let the mode shapes swing</source>
        <translation>Wprawia postacie drgań w ruch</translation>
    </message>
    <message>
        <source>Use this shaft</source>
        <translation>Użyj tego wału</translation>
    </message>
    <message>
        <source>Keep it in the project, where other panels take it as an input</source>
        <translation>Zachowuje go w projekcie, skąd biorą go inne panele</translation>
    </message>
    <message>
        <source>Use this response</source>
        <translation>Użyj tej charakterystyki</translation>
    </message>
    <message>
        <source>Find the stability lobes of this receptance</source>
        <translation>Wyznacza krzywe workowe tej receptancji</translation>
    </message>
</context>
<context>
    <name>lathelier::speed_panel::ControlWindow</name>
    <message>
        <source>Nothing was asked yet.</source>
        <translation>Jeszcze o nic nie zapytano.</translation>
    </message>
    <message>
        <source>Asked …</source>
        <translation>Zapytano …</translation>
    </message>
    <message>
        <source>Asked; no assistant is linked.</source>
        <translation>Zapytano; żaden asystent nie jest połączony.</translation>
    </message>
    <message>
        <source>State %1: %2</source>
        <translation>Stan %1: %2</translation>
    </message>
    <message>
        <source>Assistant linked · heartbeat %1</source>
        <translation>Asystent połączony · sygnał życia %1</translation>
    </message>
    <message>
        <source>No assistant on port %1</source>
        <translation>Brak asystenta na porcie %1</translation>
    </message>
    <message>
        <source>Control (simulated)</source>
        <translation>Sterowanie (symulowane)</translation>
    </message>
    <message>
        <source>The machine runs</source>
        <translation>Maszyna pracuje</translation>
    </message>
    <message>
        <source>Ask for a stable speed</source>
        <translation>Zapytaj o stabilną prędkość</translation>
    </message>
</context>
<context>
    <name>lathelier::speed_panel::LinkBar</name>
    <message>
        <source>Open the configuration of a link</source>
        <translation>Otwórz konfigurację połączenia</translation>
    </message>
    <message>
        <source>ASSIST.json (*.json)</source>
        <translation>ASSIST.json (*.json)</translation>
    </message>
    <message>
        <source>Not linked: nothing is written.</source>
        <translation>Brak połączenia: nic nie jest zapisywane.</translation>
    </message>
    <message>
        <source>The machine&apos;s spindle is needed first.</source>
        <translation>Najpierw potrzebne jest wrzeciono maszyny.</translation>
    </message>
    <message>
        <source>Linking …</source>
        <translation>Łączenie …</translation>
    </message>
    <message>
        <source>Linked to %1: waiting for a request.</source>
        <translation>Połączono z %1: czekanie na pytanie.</translation>
    </message>
    <message>
        <source>Request %1 refused: %2.</source>
        <translation>Pytanie %1 odrzucone: %2.</translation>
    </message>
    <message>
        <source>Request %1: %2 → %3 %4, written.</source>
        <translation>Pytanie %1: %2 → %3 %4, zapisano.</translation>
    </message>
    <message>
        <source>Not verified on a real control. %1</source>
        <translation>Nie sprawdzono na prawdziwym sterowaniu. %1</translation>
    </message>
    <message>
        <source>Link</source>
        <translation>Połącz</translation>
    </message>
    <message>
        <source>Answer the requests of a control: read its values, write the stable speed. Starts nothing.</source>
        <translation>Odpowiada na pytania sterowania: odczytuje jego wartości, zapisuje stabilną prędkość. Niczego nie uruchamia.</translation>
    </message>
    <message>
        <source>Configuration …</source>
        <translation>Konfiguracja …</translation>
    </message>
    <message>
        <source>ASSIST.json: limits of the machine, address and registers of the control</source>
        <translation>ASSIST.json: granice maszyny, adres i rejestry sterowania</translation>
    </message>
    <message>
        <source>Simulator …</source>
        <translation>Symulator …</translation>
    </message>
    <message>
        <source>Open a control in a window of its own, to see both sides of the link</source>
        <translation>Otwiera sterowanie w osobnym oknie, by widzieć obie strony połączenia</translation>
    </message>
    <message>
        <source>Kind of the control</source>
        <translation>Rodzaj sterowania</translation>
    </message>
</context>
<context>
    <name>lathelier::speed_panel::OperatorKeys</name>
    <message>
        <source>%1: from %2 to %3 %4</source>
        <translation>%1: od %2 do %3 %4</translation>
    </message>
    <message>
        <source>Decimal mark</source>
        <translation>Znak dziesiętny</translation>
    </message>
    <message>
        <source>Erase one sign</source>
        <translation>Usuń jeden znak</translation>
    </message>
    <message>
        <source>Clear the value</source>
        <translation>Wyczyść wartość</translation>
    </message>
    <message>
        <source>Next value</source>
        <translation>Następna wartość</translation>
    </message>
    <message>
        <source>Take over</source>
        <translation>Przyjmij</translation>
    </message>
</context>
<context>
    <name>lathelier::speed_panel::SpeedPanel</name>
    <message>
        <source>Type a value</source>
        <translation>Podaj wartość</translation>
    </message>
    <message>
        <source>Request of the control</source>
        <translation>Pytanie sterowania</translation>
    </message>
</context>
<context>
    <name>lathelier::speed_panel::SpeedViews</name>
    <message>
        <source>Operator</source>
        <translation>Operator</translation>
    </message>
    <message>
        <source>Lobes</source>
        <translation>Worki</translation>
    </message>
    <message>
        <source>Real and imaginary</source>
        <translation>Rzeczywista i urojona</translation>
    </message>
    <message>
        <source>Stable speeds</source>
        <translation>Prędkości stabilne</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::ComparisonView</name>
    <message>
        <source>Side by side</source>
        <translation>Obok siebie</translation>
    </message>
    <message>
        <source>Both pictures; zoom and place are the same in both</source>
        <translation>Oba obrazy; powiększenie i miejsce są w obu takie same</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Suwak</translation>
    </message>
    <message>
        <source>One picture over the other, parted where the slider stands</source>
        <translation>Jeden obraz na drugim, rozdzielone w miejscu suwaka</translation>
    </message>
    <message>
        <source>Where before ends and after begins</source>
        <translation>Gdzie kończy się „przed”, a zaczyna „po”</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>Magnifier</source>
        <translation>Lupa</translation>
    </message>
    <message>
        <source>Shows the same place of both pictures four times as large</source>
        <translation>Pokazuje to samo miejsce obu zdjęć czterokrotnie powiększone</translation>
    </message>
    <message>
        <source>Lay over</source>
        <translation>Nałóż</translation>
    </message>
    <message>
        <source>Click one place, such as a shoulder, in both pictures: they are laid over each other there</source>
        <translation>Kliknij jedno miejsce, na przykład odsadzenie, na obu zdjęciach: tam zostaną na siebie nałożone</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::GeneratorPane</name>
    <message>
        <source>f_c / n = %1 Hz / %2 Hz = m + ν = %3 %4 %5</source>
        <translation>f_c / n = %1 Hz / %2 Hz = m + ν = %3 %4 %5</translation>
    </message>
    <message>
        <source>ε = %1°</source>
        <translation>ε = %1°</translation>
    </message>
    <message>
        <source>Bands along the axis every f / |ν| = %1</source>
        <translation>Pasma wzdłuż osi co f / |ν| = %1</translation>
    </message>
    <message>
        <source>Waves round the part every πD / m = %1</source>
        <translation>Fale na obwodzie części co πD / m = %1</translation>
    </message>
    <message>
        <source>Crests to the axis: %1°</source>
        <translation>Grzbiety względem osi: %1°</translation>
    </message>
    <message>
        <source>Depth of a feed mark f² / 8r = %1</source>
        <translation>Głębokość śladu posuwu f² / 8r = %1</translation>
    </message>
    <message>
        <source>Picture that is made</source>
        <translation>Wytwarzany obraz</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::Overlays</name>
    <message>
        <source>feed marks, %1 apart</source>
        <translation>ślady posuwu co %1</translation>
    </message>
    <message>
        <source>chatter marks, along the axis every %1</source>
        <translation>ślady drgań, wzdłuż osi co %1</translation>
    </message>
    <message>
        <source>chatter marks</source>
        <translation>ślady drgań</translation>
    </message>
    <message>
        <source>line %1 of the spectrum</source>
        <translation>prążek %1 widma</translation>
    </message>
    <message>
        <source>found: %1</source>
        <translation>znaleziono: %1</translation>
    </message>
    <message>
        <source>feed: %1</source>
        <translation>posuw: %1</translation>
    </message>
    <message>
        <source>The evaluation says: %1</source>
        <translation>Wynik oceny: %1</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::PhotographView</name>
    <message>
        <source>%1 px are</source>
        <translation>%1 px to</translation>
    </message>
    <message>
        <source>%1: set the scale</source>
        <translation>%1: ustaw skalę</translation>
    </message>
    <message>
        <source>Ø %1 between the edges</source>
        <translation>Ø %1 między krawędziami</translation>
    </message>
    <message>
        <source>Drag over the part that is to be evaluated</source>
        <translation>Zaznacz przeciągnięciem oceniany fragment</translation>
    </message>
    <message>
        <source>Click both ends of a scale bar, or both edges of the part</source>
        <translation>Kliknij oba końce paska skali albo obie krawędzie części</translation>
    </message>
    <message>
        <source>Drag an arrow the way the tool was fed</source>
        <translation>Przeciągnij strzałkę w kierunku posuwu narzędzia</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Oglądanie</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Obszar</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skala</translation>
    </message>
    <message>
        <source>Direction of feed</source>
        <translation>Kierunek posuwu</translation>
    </message>
    <message>
        <source>Wheel zooms, drag moves, double click shows all</source>
        <translation>Kółko powiększa, przeciąganie przesuwa, podwójne kliknięcie pokazuje całość</translation>
    </message>
    <message>
        <source>Choose the part of the picture that is evaluated</source>
        <translation>Wybierz oceniany fragment obrazu</translation>
    </message>
    <message>
        <source>State a length by two clicks</source>
        <translation>Podaj długość dwoma kliknięciami</translation>
    </message>
    <message>
        <source>State the direction of feed by an arrow</source>
        <translation>Podaj kierunek posuwu strzałką</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Cały obraz</translation>
    </message>
    <message>
        <source>Length between the two clicks</source>
        <translation>Długość między dwoma kliknięciami</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Zdjęcie</translation>
    </message>
    <message>
        <source>Both pictures taken alike</source>
        <translation>Oba zdjęcia wykonane tak samo</translation>
    </message>
    <message>
        <source>Scale and direction go for both pictures; without the tick for the one that is shown</source>
        <translation>Skala i kierunek dotyczą obu zdjęć; bez zaznaczenia tylko pokazanego</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::PictureView</name>
    <message>
        <source>%1: zoom in to see them</source>
        <translation>%1: powiększ, aby je zobaczyć</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::QuizPane</name>
    <message>
        <source>Question %1</source>
        <translation>Pytanie %1</translation>
    </message>
    <message>
        <source>D = %1, f = %2, N = %3, n = N / 60 = %4</source>
        <translation>D = %1, f = %2, N = %3, n = N / 60 = %4</translation>
    </message>
    <message>
        <source>Measure in the view Marks, where the circumference is laid flat:</source>
        <translation>Mierz w widoku Ślady, gdzie obwód jest rozłożony na płasko:</translation>
    </message>
    <message>
        <source>period of the bands along the axis p: |ν| = f / p</source>
        <translation>okres pasów wzdłuż osi p: |ν| = f / p</translation>
    </message>
    <message>
        <source>pitch of the bands round the part u: m = πD / u, a whole number</source>
        <translation>podziałka pasów na obwodzie u: m = πD / u, liczba całkowita</translation>
    </message>
    <message>
        <source>bands that lean like \ : ν &lt; 0, like / : ν &gt; 0</source>
        <translation>pasy pochylone jak \ : ν &lt; 0, jak / : ν &gt; 0</translation>
    </message>
    <message>
        <source>f_c = n (m + ν)</source>
        <translation>f_c = n (m + ν)</translation>
    </message>
    <message>
        <source>Ask me</source>
        <translation>Zapytaj mnie</translation>
    </message>
    <message>
        <source>A picture whose frequency is to be found with ruler and formula</source>
        <translation>Obraz, którego częstotliwość trzeba znaleźć linijką i wzorem</translation>
    </message>
    <message>
        <source>Your f_c (%1)</source>
        <translation>Twoje f_c (%1)</translation>
    </message>
    <message>
        <source>Frequency that was read off the picture</source>
        <translation>Częstotliwość odczytana z obrazu</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Sprawdź</translation>
    </message>
    <message>
        <source>Compare the answer with the picture, and show everything</source>
        <translation>Porównaj odpowiedź z obrazem i pokaż wszystko</translation>
    </message>
    <message>
        <source>Next question</source>
        <translation>Następne pytanie</translation>
    </message>
    <message>
        <source>Another picture</source>
        <translation>Inny obraz</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::SurfaceBar</name>
    <message>
        <source>Send %1 to the lobe chart</source>
        <translation>Przekaż %1 do wykresu krzywych workowych</translation>
    </message>
    <message>
        <source>The reading that is used</source>
        <translation>Używany odczyt</translation>
    </message>
    <message>
        <source>Use this reading of the marks</source>
        <translation>Użyj tego odczytu śladów</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>Przed</translation>
    </message>
    <message>
        <source>After</source>
        <translation>Po</translation>
    </message>
    <message>
        <source>The panel Lobes marks the speed, and the frequency over it</source>
        <translation>Panel Krzywe workowe zaznacza prędkość, a nad nią częstotliwość</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::SurfacePanel</name>
    <message>
        <source>Choose a region</source>
        <translation>Wybierz obszar</translation>
    </message>
    <message>
        <source>Take the whole picture</source>
        <translation>Weź cały obraz</translation>
    </message>
    <message>
        <source>Set the scale</source>
        <translation>Ustaw skalę</translation>
    </message>
    <message>
        <source>Set the direction of feed</source>
        <translation>Ustaw kierunek posuwu</translation>
    </message>
    <message>
        <source>Choose a reading of the marks</source>
        <translation>Wybierz odczyt śladów</translation>
    </message>
    <message>
        <source>Change the picture that is made</source>
        <translation>Zmień wytwarzany obraz</translation>
    </message>
    <message>
        <source>%1 × %2 px, %3 bit</source>
        <translation>%1 × %2 px, %3 bitów</translation>
    </message>
    <message>
        <source>Picture (*.svg)</source>
        <translation>Obraz (*.svg)</translation>
    </message>
    <message>
        <source>Picture that was made (PNG)…</source>
        <translation>Wytworzony obraz (PNG)…</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>Obraz (*.png)</translation>
    </message>
    <message>
        <source>Picture with its marks (SVG)…</source>
        <translation>Obraz ze śladami (SVG)…</translation>
    </message>
    <message>
        <source>Picture after with its marks (SVG)…</source>
        <translation>Obraz po ze śladami (SVG)…</translation>
    </message>
    <message>
        <source>Before and after (SVG)…</source>
        <translation>Przed i po (SVG)…</translation>
    </message>
    <message>
        <source>Take both pictures alike</source>
        <translation>Traktuj oba zdjęcia jednakowo</translation>
    </message>
    <message>
        <source>Take the pictures apart</source>
        <translation>Traktuj zdjęcia osobno</translation>
    </message>
    <message>
        <source>Lay the pictures over each other</source>
        <translation>Nałóż zdjęcia na siebie</translation>
    </message>
    <message>
        <source>Ask a question</source>
        <translation>Zadaj pytanie</translation>
    </message>
    <message>
        <source>Leave the questions</source>
        <translation>Zakończ pytania</translation>
    </message>
    <message>
        <source>Answer the question</source>
        <translation>Odpowiedz na pytanie</translation>
    </message>
    <message>
        <source>Take the next question</source>
        <translation>Weź następne pytanie</translation>
    </message>
</context>
<context>
    <name>lathelier::surface_panel::SurfaceViews</name>
    <message>
        <source>Marks</source>
        <translation>Ślady</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Widmo</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>Przed i po</translation>
    </message>
    <message>
        <source>Photograph</source>
        <translation>Zdjęcie</translation>
    </message>
    <message>
        <source>Unrolled</source>
        <translation>Rozwinięcie</translation>
    </message>
    <message>
        <source>What the picture says</source>
        <translation>Co mówi obraz</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Model</translation>
    </message>
    <message>
        <source>Tables</source>
        <translation>Tabele</translation>
    </message>
    <message>
        <source>Feed marks</source>
        <translation>Ślady posuwu</translation>
    </message>
    <message>
        <source>Draw the crests of the feed marks over the picture</source>
        <translation>Rysuj na obrazie grzbiety śladów posuwu</translation>
    </message>
    <message>
        <source>Chatter marks</source>
        <translation>Ślady drgań</translation>
    </message>
    <message>
        <source>Draw the crests of the chatter marks over the picture</source>
        <translation>Rysuj na obrazie grzbiety śladów drgań</translation>
    </message>
    <message>
        <source>Picture without its uneven light, with its marks</source>
        <translation>Obraz bez nierównomiernego oświetlenia, ze śladami</translation>
    </message>
    <message>
        <source>Picture with the circumference laid flat</source>
        <translation>Obraz z rozwiniętym obwodem</translation>
    </message>
    <message>
        <source>A click on a ring draws its stripes over the picture</source>
        <translation>Kliknięcie pierścienia rysuje na obrazie jego pasy</translation>
    </message>
    <message>
        <source>Lines over the noise</source>
        <translation>Prążki ponad szumem</translation>
    </message>
    <message>
        <source>Chatter frequency of the model</source>
        <translation>Częstotliwość drgań z modelu</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Liczby</translation>
    </message>
    <message>
        <source>What speed next</source>
        <translation>Jaka prędkość dalej</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Zmierz</translation>
    </message>
    <message>
        <source>Two clicks show their distance, along the axis and round the part</source>
        <translation>Dwa kliknięcia pokazują odległość, wzdłuż osi i po obwodzie</translation>
    </message>
    <message>
        <source>Laid over each other where one place was clicked in both</source>
        <translation>Nałożone tam, gdzie kliknięto jedno miejsce na obu</translation>
    </message>
</context>
<context>
    <name>lathelier::tap_panel::TapPanel</name>
    <message>
        <source>%L1 channels · %L2 samples</source>
        <translation>kanały: %L1 · próbki: %L2</translation>
    </message>
</context>
<context>
    <name>lathelier::tap_panel::TapViews</name>
    <message>
        <source>Magnitude</source>
        <translation>Moduł</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Siła</translation>
    </message>
    <message>
        <source>Sensor</source>
        <translation>Czujnik</translation>
    </message>
    <message>
        <source>Spectrum of the force</source>
        <translation>Widmo siły</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Faza</translation>
    </message>
    <message>
        <source>Hits</source>
        <translation>Uderzenia</translation>
    </message>
    <message>
        <source>Coherence</source>
        <translation>Koherencja</translation>
    </message>
    <message>
        <source>Use this response</source>
        <translation>Użyj tej charakterystyki</translation>
    </message>
    <message>
        <source>Keeps the response in the project: for modes, lobes and speeds</source>
        <translation>Zachowuje charakterystykę w projekcie: dla postaci, krzywych workowych i prędkości</translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::ExercisePane</name>
    <message numerus="yes">
        <source>%n answer(s)</source>
        <translation>
            <numerusform>%n odpowiedź</numerusform>
            <numerusform>%n odpowiedzi</numerusform>
            <numerusform>%n odpowiedzi</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 points</source>
        <translation>%1 z %2 punktów</translation>
    </message>
    <message numerus="yes">
        <source>Listen (%n left)</source>
        <translation>
            <numerusform>Posłuchaj (zostało %n)</numerusform>
            <numerusform>Posłuchaj (zostały %n)</numerusform>
            <numerusform>Posłuchaj (zostało %n)</numerusform>
        </translation>
    </message>
    <message>
        <source>✓ Right.</source>
        <translation>✓ Dobrze.</translation>
    </message>
    <message>
        <source>✗ Not right.</source>
        <translation>✗ Źle.</translation>
    </message>
    <message>
        <source>%1 of 10 points. Right: %2.</source>
        <translation>%1 z 10 punktów. Poprawnie: %2.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Imię</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Ćwiczenie</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Numer</translation>
    </message>
    <message>
        <source>The same number gives the same exercise to everyone</source>
        <translation>Ten sam numer daje każdemu to samo ćwiczenie</translation>
    </message>
    <message>
        <source>Begin the exercise</source>
        <translation>Zacznij ćwiczenie</translation>
    </message>
    <message>
        <source>Speed (1/min)</source>
        <translation>Prędkość (obr/min)</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Odpowiedź</translation>
    </message>
    <message>
        <source>Sheet of results…</source>
        <translation>Arkusz wyników…</translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::SpindleView</name>
    <message>
        <source>The turning part and a dial gauge at the tool</source>
        <translation>Obracająca się część i czujnik zegarowy przy narzędziu</translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::TourPane</name>
    <message>
        <source>Step %1 of %2 · %3 done</source>
        <translation>Krok %1 z %2 · zrobione %3</translation>
    </message>
    <message numerus="yes">
        <source>%n step(s)</source>
        <translation>
            <numerusform>%n krok</numerusform>
            <numerusform>%n kroki</numerusform>
            <numerusform>%n kroków</numerusform>
        </translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Zrobione.</translation>
    </message>
    <message>
        <source>Task:</source>
        <translation>Zadanie:</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Zacznij</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalej</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Pomiń</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Wstecz</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Podpowiedź</translation>
    </message>
    <message>
        <source>Another lesson…</source>
        <translation>Inna lekcja…</translation>
    </message>
    <message>
        <source>A lesson of your own, written in Markdown</source>
        <translation>Własna lekcja, napisana w formacie Markdown</translation>
    </message>
    <message>
        <source>Text of the step</source>
        <translation>Tekst kroku</translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::TrainingPanel</name>
    <message>
        <source>Move the operating point</source>
        <translation>Przesuń punkt pracy</translation>
    </message>
    <message>
        <source>Step of the tour</source>
        <translation>Krok przewodnika</translation>
    </message>
    <message>
        <source>Sound (*.wav)</source>
        <translation>Dźwięk (*.wav)</translation>
    </message>
    <message>
        <source>Demonstration (sound and a folder of pictures)…</source>
        <translation>Pokaz (dźwięk i folder obrazów)…</translation>
    </message>
    <message>
        <source>Pictures of all views (SVG)…</source>
        <translation>Obrazy wszystkich widoków (SVG)…</translation>
    </message>
    <message>
        <source>Pictures (*.svg)</source>
        <translation>Obrazy (*.svg)</translation>
    </message>
    <message>
        <source>Open a lesson</source>
        <translation>Otwórz lekcję</translation>
    </message>
    <message>
        <source>Lesson (*.md)</source>
        <translation>Lekcja (*.md)</translation>
    </message>
    <message>
        <source>Sheet of results</source>
        <translation>Arkusz wyników</translation>
    </message>
    <message>
        <source>results</source>
        <translation>wyniki</translation>
    </message>
    <message>
        <source>Report (*.html);;Table (*.csv)</source>
        <translation>Raport (*.html);;Tabela (*.csv)</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Przewodnik</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Ćwiczenia</translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::TrainingViews</name>
    <message>
        <source>Cut of the exercise</source>
        <translation>Skrawanie z ćwiczenia</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Dlaczego?</translation>
    </message>
</context>
<context>
    <name>lathelier::training_panel::TransportBar</name>
    <message>
        <source>revolution %L1 · %L2 s</source>
        <translation>obrót %L1 · %L2 s</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Wstrzymaj</translation>
    </message>
    <message>
        <source>Play in slow motion</source>
        <translation>Odtwórz w zwolnionym tempie</translation>
    </message>
    <message>
        <source>One revolution back</source>
        <translation>Obrót wstecz</translation>
    </message>
    <message>
        <source>One revolution on</source>
        <translation>Obrót dalej</translation>
    </message>
    <message>
        <source>Slow motion</source>
        <translation>Zwolnione tempo</translation>
    </message>
    <message>
        <source>Time in the cut</source>
        <translation>Czas skrawania</translation>
    </message>
    <message>
        <source>Sound of the cut</source>
        <translation>Dźwięk skrawania</translation>
    </message>
    <message>
        <source>Sound of the cut: this computer has no device for it; the meter shows it, and Export writes it as a file</source>
        <translation>Dźwięk skrawania: ten komputer nie ma urządzenia dźwiękowego; pokazuje go wskaźnik, a Eksport zapisuje do pliku</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Głośność</translation>
    </message>
    <message>
        <source>Loudness</source>
        <translation>Poziom dźwięku</translation>
    </message>
    <message>
        <source>picture %1 of %2</source>
        <translation>obraz %1 z %2</translation>
    </message>
    <message>
        <source>Stop writing pictures</source>
        <translation>Przerwij zapis obrazów</translation>
    </message>
</context>
<context>
    <name>lathelier::trajectory_common::AngleBar</name>
    <message>
        <source>Play: run around the part by angle</source>
        <translation>Odtwarzaj: obiegaj część według kąta</translation>
    </message>
    <message>
        <source>Marked angle on the part</source>
        <translation>Zaznaczony kąt na części</translation>
    </message>
</context>
<context>
    <name>lathelier::trajectory_common::SectionBar</name>
    <message>
        <source>Section %1 of %2</source>
        <translation>Przekrój %1 z %2</translation>
    </message>
    <message>
        <source>The section before</source>
        <translation>Poprzedni przekrój</translation>
    </message>
    <message>
        <source>The next section</source>
        <translation>Następny przekrój</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>najgorszy</translation>
    </message>
    <message>
        <source>Always the section with the largest roundness deviation</source>
        <translation>Zawsze przekrój o największej odchyłce okrągłości</translation>
    </message>
    <message>
        <source> · z %1</source>
        <translation> · z %1</translation>
    </message>
    <message>
        <source>The section that all panels of Roundness show</source>
        <translation>Przekrój, który pokazują wszystkie panele pytania Okrągłość</translation>
    </message>
</context>
<context>
    <name>lathelier::trajectory_common::SpindlePanel</name>
    <message>
        <source>%L1 points</source>
        <translation>punkty: %L1</translation>
    </message>
    <message>
        <source>averages of %L1 sections</source>
        <translation>średnie przekrojów: %L1</translation>
    </message>
    <message>
        <source>%L1 channels</source>
        <translation>kanały: %L1</translation>
    </message>
    <message>
        <source>%L1 frames</source>
        <translation>ramki: %L1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Choose section %1</source>
        <translation>Wybierz przekrój %1</translation>
    </message>
    <message>
        <source>Choose the worst section</source>
        <translation>Wybierz najgorszy przekrój</translation>
    </message>
</context>
<context>
    <name>lathelier::trajectory_panel::ChannelTable</name>
    <message>
        <source>not stated</source>
        <translation>nie podano</translation>
    </message>
    <message>
        <source>not used</source>
        <translation>nieużywany</translation>
    </message>
    <message>
        <source>revolution marker</source>
        <translation>znacznik obrotu</translation>
    </message>
    <message>
        <source>angle of an encoder</source>
        <translation>kąt z enkodera</translation>
    </message>
    <message>
        <source> (workpiece axis)</source>
        <translation> (oś przedmiotu)</translation>
    </message>
    <message>
        <source> (tool)</source>
        <translation> (narzędzie)</translation>
    </message>
    <message>
        <source>Channels of the record</source>
        <translation>Kanały zapisu</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nazwa</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Jednostka</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Zakres</translation>
    </message>
    <message>
        <source>Gain</source>
        <translation>Wzmocnienie</translation>
    </message>
    <message>
        <source>Signal</source>
        <translation>Sygnał</translation>
    </message>
    <message>
        <source>Signal of channel %1</source>
        <translation>Sygnał kanału %1</translation>
    </message>
    <message>
        <source>Sensitivity (µm/V)</source>
        <translation>Czułość (µm/V)</translation>
    </message>
    <message>
        <source>Calibrated</source>
        <translation>Wzorcowano</translation>
    </message>
    <message>
        <source>Date of the calibration, for the report</source>
        <translation>Data wzorcowania, do raportu</translation>
    </message>
    <message>
        <source>The sensitivity of all probes</source>
        <translation>Czułość wszystkich sond</translation>
    </message>
    <message>
        <source>Assumed: nobody has stated it</source>
        <translation>Założono: nikt jej nie podał</translation>
    </message>
    <message>
        <source>By the certificate of the probe; empty: the sensitivity of all probes</source>
        <translation>Według świadectwa sondy; puste: czułość wszystkich sond</translation>
    </message>
</context>
<context>
    <name>lathelier::trajectory_panel::TrajectoryCharts</name>
    <message>
        <source>workpiece axis</source>
        <translation>oś przedmiotu</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>narzędzie</translation>
    </message>
    <message>
        <source>synchronous %1</source>
        <translation>synchroniczne %1</translation>
    </message>
    <message>
        <source>asynchronous %1</source>
        <translation>asynchroniczne %1</translation>
    </message>
    <message>
        <source>total %1</source>
        <translation>całkowite %1</translation>
    </message>
</context>
<context>
    <name>lathelier::trajectory_panel::TrajectoryPanel</name>
    <message>
        <source>Change the channels</source>
        <translation>Zmień kanały</translation>
    </message>
    <message>
        <source>Change a calibration</source>
        <translation>Zmiana wzorcowania</translation>
    </message>
</context>
<context>
    <name>lathelier::trajectory_panel::TrajectoryViews</name>
    <message>
        <source>ISO 230-7, fixed sensitive direction, %1 revolutions: %2</source>
        <translation>ISO 230-7, stały kierunek czuły, obroty: %1: bicie %2</translation>
    </message>
    <message>
        <source>The first of %1 records:</source>
        <translation>Pierwszy z %1 zapisów:</translation>
    </message>
    <message>
        <source>Recorder: %1</source>
        <translation>Rejestrator: %1</translation>
    </message>
    <message>
        <source>Recorded: %1</source>
        <translation>Zapisano: %1</translation>
    </message>
    <message>
        <source>%1 frames a second, %2 s, %3 channels</source>
        <translation>%1 ramek na sekundę, %2 s, kanały: %3</translation>
    </message>
    <message>
        <source>Averages over the revolutions: %1 sections</source>
        <translation>Średnie z obrotów: przekroje: %1</translation>
    </message>
    <message>
        <source>The file says: %1</source>
        <translation>Plik podaje: %1</translation>
    </message>
    <message>
        <source>Workpiece axis (blue) and tool (orange) of all sections along z; displacements × %1</source>
        <translation>Oś przedmiotu (niebieska) i narzędzie (pomarańczowe) wszystkich przekrojów wzdłuż z; przemieszczenia × %1</translation>
    </message>
    <message>
        <source>all sections</source>
        <translation>wszystkie przekroje</translation>
    </message>
    <message>
        <source>Draw the trajectories of all sections behind the chosen one</source>
        <translation>Rysuj trajektorie wszystkich przekrojów za wybraną</translation>
    </message>
    <message>
        <source>Synthetic data</source>
        <translation>Dane syntetyczne</translation>
    </message>
    <message>
        <source>The probe whose error motion is shown</source>
        <translation>Czujnik, którego bicie jest pokazane</translation>
    </message>
    <message>
        <source>Trajectories</source>
        <translation>Trajektorie</translation>
    </message>
    <message>
        <source>Signals</source>
        <translation>Sygnały</translation>
    </message>
    <message>
        <source>All sections in 3-D</source>
        <translation>Wszystkie przekroje w 3D</translation>
    </message>
    <message>
        <source>Record and channels</source>
        <translation>Zapis i kanały</translation>
    </message>
    <message>
        <source>section %1, angle %2°</source>
        <translation>przekrój %1, kąt %2°</translation>
    </message>
    <message>
        <source>Error motion</source>
        <translation>Ruch błędu</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Współrzędne</translation>
    </message>
</context>
<context>
    <name>lathelier::turning_panel::CourseCharts</name>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Speed of the spindle along the part</source>
        <translation>Prędkość obrotowa wrzeciona wzdłuż części</translation>
    </message>
    <message>
        <source>v_c</source>
        <translation>v_c</translation>
    </message>
    <message>
        <source>Cutting speed along the part</source>
        <translation>Prędkość skrawania wzdłuż części</translation>
    </message>
    <message>
        <source>f_m</source>
        <translation>f_m</translation>
    </message>
    <message>
        <source>Frequency of chatter of each section; needs a spindle</source>
        <translation>Częstotliwość drgań samowzbudnych każdego odcinka; wymaga wrzeciona</translation>
    </message>
    <message>
        <source>Rz</source>
        <translation>Rz</translation>
    </message>
    <message>
        <source>Ideal roughness along the part</source>
        <translation>Teoretyczna chropowatość wzdłuż części</translation>
    </message>
</context>
<context>
    <name>lathelier::turning_panel::OperationsPane</name>
    <message>
        <source>✗ “%1” cannot run before “%2”: %3.</source>
        <translation>✗ „%1” nie może poprzedzać „%2”: %3.</translation>
    </message>
    <message>
        <source>Run this operation earlier (Alt+Up)</source>
        <translation>Wykonaj tę operację wcześniej (Alt+strzałka w górę)</translation>
    </message>
    <message>
        <source>Run this operation earlier</source>
        <translation>Wykonaj tę operację wcześniej</translation>
    </message>
    <message>
        <source>Run this operation later (Alt+Down)</source>
        <translation>Wykonaj tę operację później (Alt+strzałka w dół)</translation>
    </message>
    <message>
        <source>Run this operation later</source>
        <translation>Wykonaj tę operację później</translation>
    </message>
    <message>
        <source>Reset order</source>
        <translation>Przywróć kolejność</translation>
    </message>
    <message>
        <source>Back to the usual order of operations</source>
        <translation>Wraca do zwykłej kolejności operacji</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operacje</translation>
    </message>
    <message>
        <source>The box switches an operation off: what it would take off stays. Drag a row by its number, or use the arrows, to run an operation earlier or later.</source>
        <translation>Pole wyłącza operację: to, co by zdjęła, zostaje. Przeciągnij wiersz za numer albo użyj strzałek, by wykonać operację wcześniej lub później.</translation>
    </message>
</context>
<context>
    <name>lathelier::turning_panel::ProgramBar</name>
    <message>
        <source>planned</source>
        <translation>zaplanowany</translation>
    </message>
    <message>
        <source>compensated</source>
        <translation>skompensowany</translation>
    </message>
    <message>
        <source>%1, changed by hand</source>
        <translation>%1, zmieniony ręcznie</translation>
    </message>
    <message>
        <source>? Check void: the text was changed after it</source>
        <translation>? Kontrola nieważna: tekst zmieniono po niej</translation>
    </message>
    <message>
        <source>✗ The program has errors</source>
        <translation>✗ Program zawiera błędy</translation>
    </message>
    <message>
        <source>? Not checked: the program before it is not</source>
        <translation>? Niesprawdzony: poprzedni program nie jest sprawdzony</translation>
    </message>
    <message>
        <source>✓ %1, checked</source>
        <translation>✓ %1, sprawdzony</translation>
    </message>
    <message>
        <source>✗ %1: cuts into the drawing</source>
        <translation>✗ %1: wcina się w zarys</translation>
    </message>
    <message>
        <source>✗ %1, findings: %2</source>
        <translation>✗ %1, wykryte błędy: %2</translation>
    </message>
    <message>
        <source>Hands it to the panels Deflection, Correction and Program, with its bar</source>
        <translation>Daje go wraz z prętem panelom Ugięcie, Korekcja i Program</translation>
    </message>
    <message>
        <source>Only a program that was checked and has no findings is handed on</source>
        <translation>Przekazać można tylko program sprawdzony i bez błędów</translation>
    </message>
    <message>
        <source>Check again</source>
        <translation>Sprawdź ponownie</translation>
    </message>
    <message>
        <source>Checks the text as it stands here against drawing, stock and chuck</source>
        <translation>Sprawdza obecny tekst względem rysunku, materiału i uchwytu</translation>
    </message>
    <message>
        <source>Take back changes</source>
        <translation>Cofnij zmiany</translation>
    </message>
    <message>
        <source>The program as it was before it was changed by hand</source>
        <translation>Program sprzed ręcznych zmian</translation>
    </message>
    <message>
        <source>Use this program</source>
        <translation>Użyj tego programu</translation>
    </message>
    <message>
        <source>? %1: a tool is not in the job, what it cuts is not checked</source>
        <translation>? %1: narzędzia nie ma w zadaniu; to, co ono skrawa, nie jest sprawdzone</translation>
    </message>
</context>
<context>
    <name>lathelier::turning_panel::ToolScrubber</name>
    <message>
        <source>Pause</source>
        <translation>Pauza</translation>
    </message>
    <message>
        <source>Play the program</source>
        <translation>Odtwórz program</translation>
    </message>
    <message>
        <source>Clamping 1</source>
        <translation>Zamocowanie 1</translation>
    </message>
    <message>
        <source>Clamping 2</source>
        <translation>Zamocowanie 2</translation>
    </message>
    <message>
        <source>Place along the program</source>
        <translation>Miejsce wzdłuż programu</translation>
    </message>
    <message>
        <source>Place along the program: the tool moves, the stock is as it is by then</source>
        <translation>Miejsce w programie: narzędzie się przesuwa, półfabrykat jest taki jak w tej chwili</translation>
    </message>
</context>
<context>
    <name>lathelier::turning_panel::TurningPanel</name>
    <message>
        <source>Switch on: %1</source>
        <translation>Włącz: %1</translation>
    </message>
    <message>
        <source>Switch off: %1</source>
        <translation>Wyłącz: %1</translation>
    </message>
    <message>
        <source>%L1 tools, with its shaft</source>
        <translation>Narzędzia: %L1, wraz z wałkiem</translation>
    </message>
    <message>
        <source>%L1 tools</source>
        <translation>Narzędzia: %L1</translation>
    </message>
    <message>
        <source>%L1 segments · %2</source>
        <translation>odcinków: %L1 · %2</translation>
    </message>
    <message>
        <source>Programs of both clampings…</source>
        <translation>Programy obu zamocowań…</translation>
    </message>
    <message>
        <source>Turning program…</source>
        <translation>Program tokarski…</translation>
    </message>
    <message>
        <source>NC program (*.nc *.ngc *.mpf *.tap)</source>
        <translation>Program NC (*.nc *.ngc *.mpf *.tap)</translation>
    </message>
    <message>
        <source>Moves of the tool, clamping %1 (CSV)…</source>
        <translation>Ruchy narzędzia, zamocowanie %1 (CSV)…</translation>
    </message>
    <message>
        <source>Moves of the tool (CSV)…</source>
        <translation>Ruchy narzędzia (CSV)…</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabela (*.csv)</translation>
    </message>
    <message>
        <source>Move: %1</source>
        <translation>Przesuń: %1</translation>
    </message>
    <message>
        <source>Reset the order of operations</source>
        <translation>Przywróć kolejność operacji</translation>
    </message>
    <message>
        <source>Edit the program</source>
        <translation>Zmień program</translation>
    </message>
    <message>
        <source>Take back the changes of the program</source>
        <translation>Cofnij zmiany programu</translation>
    </message>
    <message>
        <source>Check the program again</source>
        <translation>Sprawdź program ponownie</translation>
    </message>
    <message>
        <source>%L1 blocks</source>
        <translation>bloki: %L1</translation>
    </message>
    <message>
        <source>Set-up sheet (HTML)…</source>
        <translation>Karta ustawcza (HTML)…</translation>
    </message>
    <message>
        <source>Page (*.html)</source>
        <translation>Strona (*.html)</translation>
    </message>
</context>
<context>
    <name>lathelier::turning_panel::TurningViews</name>
    <message>
        <source>%1, %2 deep</source>
        <translation>%1, głębokość %2</translation>
    </message>
    <message>
        <source>Line %1 · %2 · tool %3 · Ø %4 · Z %5</source>
        <translation>Wiersz %1 · %2 · narzędzie %3 · Ø %4 · Z %5</translation>
    </message>
    <message>
        <source>rapid</source>
        <translation>ruch szybki</translation>
    </message>
    <message>
        <source>feed</source>
        <translation>posuw</translation>
    </message>
    <message>
        <source>Line %1: no move</source>
        <translation>Wiersz %1: brak ruchu</translation>
    </message>
    <message>
        <source>Contour and stock</source>
        <translation>Kontur i półfabrykat</translation>
    </message>
    <message>
        <source>Program and path</source>
        <translation>Program i tor</translation>
    </message>
    <message>
        <source>Operations</source>
        <translation>Operacje</translation>
    </message>
    <message>
        <source>Speeds and why</source>
        <translation>Prędkości i dlaczego</translation>
    </message>
    <message>
        <source>What stays, findings</source>
        <translation>Co zostaje, wykryte błędy</translation>
    </message>
    <message>
        <source>Set-up sheet</source>
        <translation>Karta ustawcza</translation>
    </message>
    <message>
        <source>Path of the tool</source>
        <translation>Tor narzędzia</translation>
    </message>
    <message>
        <source>Why this speed</source>
        <translation>Dlaczego ta prędkość obrotowa</translation>
    </message>
    <message>
        <source>Text of the program</source>
        <translation>Tekst programu</translation>
    </message>
    <message>
        <source>Speeds of the finish</source>
        <translation>Prędkości wykończenia</translation>
    </message>
    <message>
        <source>A row shows the stability lobes of the part at that moment</source>
        <translation>Wiersz pokazuje krzywe workowe części w danej chwili</translation>
    </message>
    <message>
        <source>What stays on the drawing</source>
        <translation>Co zostaje względem rysunku</translation>
    </message>
    <message>
        <source>What the tool meets</source>
        <translation>Na co natrafia narzędzie</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Narzędzia</translation>
    </message>
    <message>
        <source>Open in Lobes</source>
        <translation>Otwórz krzywe workowe</translation>
    </message>
    <message>
        <source>The response of the part at that moment, in the panel of lobes</source>
        <translation>Charakterystyka części w tej chwili, w panelu Krzywe workowe</translation>
    </message>
    <message>
        <source>Without a spindle there is no dynamics to choose speeds by: the finish keeps its cutting speed of %1, and the speed follows the diameter. A spindle (SPINDLE.json, or “Spindle” of the project) gives each cylinder its own speed and says why.</source>
        <translation>Bez wrzeciona nie ma dynamiki, z której wynikałyby obroty: wykańczanie zachowuje prędkość skrawania %1, a obroty zależą od średnicy. Wrzeciono (SPINDLE.json albo wrzeciono z projektu) daje każdemu walcowi jego własne obroty i podaje powód.</translation>
    </message>
    <message>
        <source>Stock</source>
        <translation>Półfabrykat</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Narzędzie</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>wiersz %1: %2</translation>
    </message>
    <message>
        <source>Part as it is cut</source>
        <translation>Część podczas skrawania</translation>
    </message>
</context>
</TS>
