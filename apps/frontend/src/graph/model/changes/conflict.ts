import type { GraphCommand } from '../commands/graph-command.ts';

/**
 * Where two people changed the same thing in different ways. The merged graph has it my way, but for
 * what I removed and they changed: that is there.
 */
export interface Conflict {
  /** Ids of what it is about. */
  readonly node: string | undefined;
  readonly wire: string | undefined;
  /** What both changed, in words: `the mode of mirror`. */
  readonly what: string;
  /** Their way, as it was before the merge; undefined: they removed it. */
  readonly theirs: unknown;
  /** My way; undefined: I removed it. */
  readonly mine: unknown;
  /** Does it their way; nothing, where it is their way already. */
  readonly takeTheirs: GraphCommand;
  /** Does it my way where the merged graph has it theirs: removes it again. */
  readonly takeMine: GraphCommand | undefined;
}
