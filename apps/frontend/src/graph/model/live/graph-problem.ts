import type { SessionRef } from '../../../sessions/words/shared-topics.ts';

/** Action that solves a problem, on this page or on another. */
export interface Remedy {
  /** Replaces the message of the problem: what is wrong and what to do. */
  readonly message: string;
  /** Label of the link or button. */
  readonly text: string;
  /** Path of the page; undefined: call `run`. */
  readonly to?: string;
  readonly run?: () => void;
}

/** Advice about a topic without a value: replaces the message of the problem, with an action if there is one. */
export type TopicAdvice =
  | Remedy
  | { readonly message: string; readonly text?: undefined; readonly run?: undefined };

/** Problem of a graph, with its element. */
export interface GraphProblem {
  /** Code of the master's problem. [SE-4] [SE-5] */
  readonly code: string;
  readonly isError: boolean;
  /** One sentence for users. */
  readonly message: string;
  /** Undefined: concerns the session as a whole. */
  readonly node: string | undefined;
  readonly port: string | undefined;
  readonly wires: readonly string[];
  /** True when another problem reports the same and this element is affected, too. */
  readonly isEcho?: boolean;
  /** What follows at the node, a few words: `Waits for value`. */
  readonly consequence?: string;
  readonly remedy?: Remedy;
  /** Other sessions that are involved. */
  readonly others?: readonly SessionRef[];
}
