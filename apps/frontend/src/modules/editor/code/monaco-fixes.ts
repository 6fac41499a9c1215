import type { ModuleDraft } from '../../draft/module-draft.ts';
import type { TextPlace } from '../../text/module-text.ts';
import { codeFixes, type CodeFix } from './code-fixes.ts';
import { monaco } from './monaco.ts';

/**
 * Offers the fixes of the problems in one model as quick fixes.
 *
 * @returns a function that stops it
 */
export function offerFixes(
  editor: monaco.editor.IStandaloneCodeEditor,
  draft: () => ModuleDraft,
  onFix: (place: TextPlace, fix: CodeFix) => void,
): () => void {
  const command = editor.addCommand(0, (_accessor, place: TextPlace, fix: CodeFix) =>
    onFix(place, fix),
  );
  const offered = monaco.languages.registerCodeActionProvider('javascript', {
    provideCodeActions(model, _range, { markers }) {
      const isOurs = model === editor.getModel() && command !== null;
      const actions = (isOurs ? markers : []).flatMap((marker) => {
        const { startLineNumber: line, startColumn: column, message } = marker;
        return codeFixes({ line, column, message }, draft()).map((fix) => ({
          title: fix.title,
          kind: 'quickfix',
          diagnostics: [marker],
          command: { id: command!, title: fix.title, arguments: [{ line, column }, fix] },
        }));
      });
      return { actions, dispose() {} };
    },
  });
  return () => offered.dispose();
}
