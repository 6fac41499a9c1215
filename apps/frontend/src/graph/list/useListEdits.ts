import { watch } from 'vue';
import { replaceClientTopics } from '../../connection/topic-parts.ts';
import { useTopicParts } from '../../connection/useTopicParts.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { useGraphContext } from '../live/useGraphContext.ts';
import { doneLabel } from '../model/commands/done-label.ts';
import type { GraphCommand } from '../model/commands/graph-command.ts';

/** Group of the toasts about changes in the list. */
export const LIST_EDITS = 'list edits';

/** Applies a command, shows a toast about it, and offers to undo it. */
export function useListEdits(): (command: GraphCommand) => void {
  const { editor } = useGraphContext();
  const toasts = useToasts();
  const { parts } = useTopicParts();
  // Removes the toast once the step was undone or followed by another one. Synchronously: later, the changes of other
  // rows would dismiss a new toast.
  watch(editor.graph, () => toasts.leave(LIST_EDITS), { flush: 'sync' });
  return (command) => {
    const before = editor.graph.value;
    editor.apply(command);
    const { value: after } = editor.graph;
    const { value: label } = editor.undoLabel;
    if (after === before || label === undefined) return;
    const run = (): void => {
      // Undo only if it is still the last step.
      if (editor.graph.value === after) editor.undo();
    };
    const words = replaceClientTopics(doneLabel(label), (topic) => parts(topic).name);
    toasts.show(words, { text: 'Undo', run }, LIST_EDITS);
  };
}
