import { watch } from 'vue';
import { replaceClientTopics } from '../../connection/topic-parts.ts';
import { useTopicParts } from '../../connection/useTopicParts.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { useGraphContext } from '../live/useGraphContext.ts';
import { doneLabel } from '../model/commands/done-label.ts';
import type { GraphCommand } from '../model/commands/graph-command.ts';

/** Toasts about what was changed in the list. */
export const LIST_EDITS = 'list edits';

/** Does what was chosen in the list, says what was done, and offers to take it back. */
export function useListEdits(): (command: GraphCommand) => void {
  const { editor } = useGraphContext();
  const toasts = useToasts();
  const { parts } = useTopicParts();
  // What was taken back, or followed by something else, is not offered to be taken back. At once: later,
  // other rows of the list would dismiss what this one says.
  watch(editor.graph, () => toasts.leave(LIST_EDITS), { flush: 'sync' });
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
    const words = replaceClientTopics(doneLabel(label), (topic) => parts(topic).name);
    toasts.show(words, { text: 'Undo', run }, LIST_EDITS);
  };
}
