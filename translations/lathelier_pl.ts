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
        <source>The kind of this file is not known; expected {expected}.</source>
        <translation type="unfinished"></translation>
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
        <source>The points all lie {found}; this determines no alignment.</source>
        <translation>Wszystkie punkty leżą {found}; to nie wyznacza dopasowania.</translation>
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
        <source>The {role} is not a body of revolution (residual {residual_mm} mm).</source>
        <translation>{role}: to nie jest bryła obrotowa (reszta {residual_mm} mm).</translation>
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
        <source>{path}: {count} rows were skipped.</source>
        <translation>{path}: liczba pominiętych wierszy: {count}.</translation>
    </message>
    <message>
        <source>{path}: {count} points without finite coordinates were left out.</source>
        <translation>{path}: pominięto punkty bez skończonych współrzędnych; ich liczba: {count}.</translation>
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
        <source>{count} points further than {distance_mm} mm from the reference were left out.</source>
        <translation>Pominięto punkty dalsze niż {distance_mm} mm od oryginału; ich liczba: {count}.</translation>
    </message>
    <message>
        <source>{count} points in the excluded zones were left out.</source>
        <translation>Pominięto punkty w strefach wyłączonych; ich liczba: {count}.</translation>
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
</context>
<context>
    <name>lathelier::FieldEditor</name>
    <message>
        <source>not given</source>
        <translation>nie podano</translation>
    </message>
</context>
<context>
    <name>lathelier::Form</name>
    <message>
        <source>Advanced</source>
        <translation>Zaawansowane</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>lathelier::HeadlineLabel</name>
    <message>
        <source>✓ within tolerance</source>
        <translation>✓ w tolerancji</translation>
    </message>
    <message>
        <source>✗ out of tolerance</source>
        <translation>✗ poza tolerancją</translation>
    </message>
</context>
<context>
    <name>lathelier::InputBox</name>
    <message>
        <source>%L1 triangles</source>
        <translation>trójkąty: %L1</translation>
    </message>
    <message>
        <source>%L1 points</source>
        <translation>punkty: %L1</translation>
    </message>
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
        <source>%L1 rows skipped</source>
        <translation>pominięte wiersze: %L1</translation>
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
    <name>lathelier::NotesLabel</name>
    <message>
        <source>Fewer notes</source>
        <translation>Mniej uwag</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>jeszcze %1</translation>
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
</context>
<context>
    <name>lathelier::PanelBase</name>
    <message>
        <source>Open: %1</source>
        <translation>Otwórz: %1</translation>
    </message>
    <message>
        <source>%1 (%2);;All files (*)</source>
        <translation>%1 (%2);;Wszystkie pliki (*)</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Otwórz %1</translation>
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
        <source>Change: %1</source>
        <translation>Zmień: %1</translation>
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
        <source>Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a report of this result as HTML or PDF</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
