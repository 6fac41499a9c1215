import messagesSource from '@ubii/proto/messages-source?raw';
import valuesSource from '@ubii/proto/data-format-values-source?raw';
import * as monaco from 'monaco-editor/editor/editor.api.js';
import EditorWorker from 'monaco-editor/editor/editor.worker.js?worker';
import 'monaco-editor/features/register.all.js';
import 'monaco-editor/languages/definitions/javascript/register.js';
import 'monaco-editor/languages/definitions/typescript/register.js';
import * as languages from 'monaco-editor/languages/features/typescript/register.js';
import TypeScriptWorker from 'monaco-editor/languages/features/typescript/ts.worker.js?worker';

/** All of Monaco in one chunk, which only the module editor loads. */
export { monaco };

/** URI of the module being edited, which exists only in the worker. */
export const MODULE_URI = 'file:///ubii/module.js';

const defaults = languages.javascriptDefaults;

// Workers are files of the master, as required by its content security policy, without eval.
globalThis.MonacoEnvironment = {
  getWorker: (_id, label) =>
    label === 'javascript' || label === 'typescript' ? new TypeScriptWorker() : new EditorWorker(),
};
defaults.setCompilerOptions({
  target: languages.ScriptTarget.ESNext,
  module: languages.ModuleKind.ESNext,
  moduleResolution: languages.ModuleResolutionKind.NodeJs,
  // Modules have no DOM and no Node.js: only the language. [PM-52]
  lib: ['lib.es2023.d.ts'],
  allowJs: true,
  checkJs: true,
  noEmit: true,
  strict: true,
  noImplicitAny: false,
  allowImportingTsExtensions: true,
  types: [],
});
// 7044: implicit any, a hint only. 80001, 80005: suggestions to convert the code.
defaults.setDiagnosticsOptions({
  diagnosticCodesToIgnore: [7043, 7044, 7045, 80001, 80004, 80005],
});
defaults.setEagerModelSync(true);
// Code actions of TypeScript edit its own files or turn checks off: code-fixes.ts has those of modules.
defaults.setModeConfiguration({ ...defaults.modeConfiguration, codeActions: false });

/** Sets the declarations that the worker uses. */
export function setDeclarations(declarations: string, state: string): void {
  defaults.setExtraLibs([
    { filePath: 'file:///ubii/generated/messages.ts', content: messagesSource },
    { filePath: 'file:///ubii/data-formats/data-format-values.ts', content: valuesSource },
    { filePath: 'file:///ubii/globals.d.ts', content: declarations },
    { filePath: 'file:///ubii/state.js', content: state },
  ]);
}
