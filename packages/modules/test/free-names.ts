import ts from 'typescript';

/** Codes of "Cannot find name", with and without a suggestion. */
const CANNOT_FIND_NAME = new Set([
  2304, 2318, 2552, 2580, 2581, 2582, 2583, 2584, 2585, 2591, 2592,
]);

/**
 * Names that source texts use and that neither they nor the language define, on every path, run or not.
 *
 * @param sources by name, each an expression
 * @returns the names by the name of the source; sources without any are left out
 */
export function freeNames(sources: ReadonlyMap<string, string>): Map<string, Set<string>> {
  const options: ts.CompilerOptions = {
    allowJs: true,
    checkJs: true,
    noEmit: true,
    lib: ['lib.es2023.d.ts'],
    target: ts.ScriptTarget.ES2023,
    moduleDetection: ts.ModuleDetectionKind.Force,
    types: [],
  };
  const host = ts.createCompilerHost(options);
  const readFile = host.getSourceFile.bind(host);
  const files = new Map([...sources].map(([name, text]) => [`/${name}.js`, `(${text}\n);`]));
  host.getSourceFile = (name, languageVersion) => {
    const text = files.get(name);
    return text === undefined
      ? readFile(name, languageVersion)
      : ts.createSourceFile(name, text, languageVersion);
  };
  host.fileExists = (name) => files.has(name) || ts.sys.fileExists(name);
  const program = ts.createProgram([...files.keys()], options, host);

  const found = new Map<string, Set<string>>();
  for (const name of sources.keys()) {
    const file = program.getSourceFile(`/${name}.js`);
    if (file === undefined) throw new Error(`${name} was not checked`);
    const names = [
      ...program.getSyntacticDiagnostics(file),
      ...program.getSemanticDiagnostics(file),
    ]
      .filter(({ code }) => CANNOT_FIND_NAME.has(code))
      .map(({ start = 0, length = 0 }) => file.text.slice(start, start + length));
    if (names.length > 0) found.set(name, new Set(names));
  }
  return found;
}
