import { useToasts } from '../../ui/toasts/toasts.ts';
import { useGraphContext } from '../editor/use-graph-editor.ts';
import type { GraphCommand } from '../model/commands/graph-command.ts';

/** Does what was chosen in the list, says what that was, and offers to take it back. */
export function useListEdits(): (command: GraphCommand) => void {
  const { editor } = useGraphContext();
  const toasts = useToasts();
  return (command) => {
    const before = editor.graph.value;
    editor.apply(command);
    const { value: after } = editor.graph;
    const { value: label } = editor.undoLabel;
    if (after === before || label === undefined) return;
    const run = (): void => {
      // Something else may have been done since: only the last step is taken back here.
      if (editor.graph.value === after) editor.undo();
    };
    toasts.show(label, { text: 'Undo', run });
  };
}
