import type { GraphCommand } from '../commands/graph-command.ts';

/**
 * Conflict: both users changed the same element in different ways. The merged graph keeps the own change, except for
 * elements that the user removed and the other one changed, which stay.
 */
export interface Conflict {
  /** Ids of the affected elements. */
  readonly node: string | undefined;
  readonly wire: string | undefined;
  /** Changed property, in words: `the mode of mirror`. */
  readonly what: string;
  /** The other user's value before the merge; undefined: removed. */
  readonly theirs: unknown;
  /** The own value; undefined: removed. */
  readonly mine: unknown;
  /** Applies the other user's change; empty if the merged graph has it already. */
  readonly takeTheirs: GraphCommand;
  /** Removes an element again that the merged graph kept; undefined if the merged graph has the own change. */
  readonly takeMine: GraphCommand | undefined;
}
