import type { GraphCommand } from '../commands/graph-command.ts';

/** Where two people changed the same thing in different ways. What is here is as I have it. */
export interface Conflict {
  /** Ids of what it is about. */
  readonly node: string | undefined;
  readonly wire: string | undefined;
  /** What both changed, in words: `the mode of mirror`. */
  readonly what: string;
  /** Their way, as it was before the merge; undefined: they removed it. */
  readonly theirs: unknown;
  /** My way, which the merged graph has; undefined: I removed it. */
  readonly mine: unknown;
  /** Does it their way instead. */
  readonly takeTheirs: GraphCommand;
}
