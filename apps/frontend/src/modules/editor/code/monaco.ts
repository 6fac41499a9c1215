import messagesSource from '@ubii/proto/messages-source?raw';
import valuesSource from '@ubii/proto/data-format-values-source?raw';
import * as monaco from 'monaco-editor/editor/editor.api.js';
import EditorWorker from 'monaco-editor/editor/editor.worker.js?worker';
import 'monaco-editor/features/register.all.js';
import 'monaco-editor/languages/definitions/javascript/register.js';
import 'monaco-editor/languages/definitions/typescript/register.js';
import * as languages from 'monaco-editor/languages/features/typescript/register.js';
import TypeScriptWorker from 'monaco-editor/languages/features/typescript/ts.worker.js?worker';

/** Everything of Monaco in one chunk, which only the editor of modules loads. */
export { monaco };

/** Where the files of the one module being edited are; they exist in the worker only. */
export const MODULE_URI = 'file:///ubii/module.js';

const defaults = languages.javascriptDefaults;

// Workers are files of the master: its policy lets nothing else in, and needs no eval.
globalThis.MonacoEnvironment = {
  getWorker: (_id, label) =>
    label === 'javascript' || label === 'typescript' ? new TypeScriptWorker() : new EditorWorker(),
};
defaults.setCompilerOptions({
  target: languages.ScriptTarget.ESNext,
  module: languages.ModuleKind.ESNext,
  moduleResolution: languages.ModuleResolutionKind.NodeJs,
  // No page and no Node around a module: only the language. [PM-52]
  lib: ['lib.es2023.d.ts'],
  allowJs: true,
  checkJs: true,
  noEmit: true,
  strict: true,
  noImplicitAny: false,
  allowImportingTsExtensions: true,
  types: [],
});
// 7044: implicit any, a hint only. 80001, 80005: proposals to make it something else.
defaults.setDiagnosticsOptions({
  diagnosticCodesToIgnore: [7043, 7044, 7045, 80001, 80004, 80005],
});
defaults.setEagerModelSync(true);

/** Tells the worker what the code sees from now on. */
export function setDeclarations(declarations: string, state: string): void {
  defaults.setExtraLibs([
    { filePath: 'file:///ubii/generated/messages.ts', content: messagesSource },
    { filePath: 'file:///ubii/data-formats/data-format-values.ts', content: valuesSource },
    { filePath: 'file:///ubii/globals.d.ts', content: declarations },
    { filePath: 'file:///ubii/state.js', content: state },
  ]);
}
