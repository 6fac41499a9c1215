import type { ModuleDraft } from '../../draft/module-draft.ts';
import { CALLBACKS, type TextPlace } from '../../text/module-text.ts';
import { resultPlace } from '../../text/return-place.ts';
import type { CodeMark, TypeMark } from './code-mark.ts';
import { monaco } from './monaco.ts';
import { typeWords } from './type-words.ts';

const OWNER = 'ubii';
/** Codes of TypeScript below this are syntax errors. */
const FIRST_TYPE_CODE = 2000;

/**
 * Rewrites the problems that TypeScript finds in terms of the module, moves them to their causes, and reports them.
 *
 * @returns a function that stops it
 */
export function followMarkers(
  model: monaco.editor.ITextModel,
  draft: () => ModuleDraft,
  onFound: (found: readonly TypeMark[]) => void,
): () => void {
  const report = (): void => {
    // Changing them causes another event.
    if (rewriteMarkers(model, draft())) return;
    const found = typeMarkers(model)
      .filter(({ severity }) => severity >= monaco.MarkerSeverity.Warning)
      .map(({ startLineNumber, startColumn, message, severity, code }) => ({
        line: startLineNumber,
        column: startColumn,
        message,
        severity:
          severity === monaco.MarkerSeverity.Error ? ('error' as const) : ('warning' as const),
        isSyntax: Number(typeof code === 'object' ? code.value : code) < FIRST_TYPE_CODE,
      }));
    onFound(found);
  };
  const following = monaco.editor.onDidChangeMarkers((changed) => {
    if (changed.some((uri) => uri.toString() === model.uri.toString())) report();
  });
  return () => following.dispose();
}

/** Underlines problems that the sandbox or a run found. */
export function setMarks(model: monaco.editor.ITextModel, marks: readonly CodeMark[]): void {
  const markers = marks.map((found) => ({
    ...rangeAt(model, found),
    message: found.message,
    severity:
      found.severity === 'error' ? monaco.MarkerSeverity.Error : monaco.MarkerSeverity.Warning,
  }));
  monaco.editor.setModelMarkers(model, OWNER, markers);
}

const typeMarkers = (model: monaco.editor.ITextModel): readonly monaco.editor.IMarker[] =>
  monaco.editor.getModelMarkers({ resource: model.uri }).filter(({ owner }) => owner !== OWNER);

/** @returns whether any was changed */
function rewriteMarkers(model: monaco.editor.ITextModel, draft: ModuleDraft): boolean {
  const byOwner = new Map<string, monaco.editor.IMarkerData[]>();
  let hasChanged = false;
  for (const marker of typeMarkers(model)) {
    const message = typeWords(marker.message, draft);
    const { line, column } = placeOf(model, marker, message);
    const isAtPlace = line === marker.startLineNumber && column === marker.startColumn;
    hasChanged ||= !isAtPlace || message !== marker.message;
    const at = isAtPlace ? marker : { ...marker, ...rangeAt(model, { line, column }) };
    byOwner.set(marker.owner, [...(byOwner.get(marker.owner) ?? []), { ...at, message }]);
  }
  if (!hasChanged) return false;
  // Markers set inside a marker listener cause no event.
  queueMicrotask(() => {
    if (model.isDisposed()) return;
    for (const [owner, list] of byOwner) monaco.editor.setModelMarkers(model, owner, list);
  });
  return true;
}

/**
 * Returns the position of an error that TypeScript reports at the name of a callback: for a wrong result the whole
 * function does not match its type, so the result is the better position.
 */
function placeOf(
  model: monaco.editor.ITextModel,
  { startLineNumber, startColumn, message }: monaco.editor.IMarker,
  words: string,
): TextPlace {
  const place = { line: startLineNumber, column: startColumn };
  const word = model.getWordAtPosition({ lineNumber: startLineNumber, column: startColumn });
  const callback = CALLBACKS.find((name) => name === word?.word);
  if (!callback || /Types of parameters|Target signature/.test(message)) return place;
  return resultPlace(model.getValue(), callback, words) ?? place;
}

/** Returns the word at a position; otherwise the rest of its line. */
function rangeAt(model: monaco.editor.ITextModel, { line, column }: TextPlace): monaco.IRange {
  const startLineNumber = Math.min(Math.max(1, line), model.getLineCount());
  const word = model.getWordAtPosition({ lineNumber: startLineNumber, column });
  return {
    startLineNumber,
    endLineNumber: startLineNumber,
    startColumn: word?.startColumn ?? column,
    endColumn: word?.endColumn ?? model.getLineMaxColumn(startLineNumber),
  };
}
