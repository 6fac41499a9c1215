import type { SessionRef } from '../../../sessions/words/shared-topics.ts';

/** What ends a problem, on another page or on this one. */
export interface Remedy {
  /** What is wrong and what to do, in place of the message of the problem. */
  readonly message: string;
  /** Of the link or button. */
  readonly text: string;
  /** Path of the page; undefined: `run` does it here. */
  readonly to?: string;
  readonly run?: () => void;
}

/** What is wrong with a topic without a value, in place of the message of the problem, and what ends it. */
export type TopicAdvice =
  Remedy | { readonly message: string; readonly text?: undefined; readonly run?: undefined };

/** Something wrong in a graph, at its place. */
export interface GraphProblem {
  /** As the master names it. [SE-4] [SE-5] */
  readonly code: string;
  readonly isError: boolean;
  /** One sentence for people. */
  readonly message: string;
  /** Undefined: about the session as a whole. */
  readonly node: string | undefined;
  readonly port: string | undefined;
  readonly wires: readonly string[];
  /** Said of something else already, and shown here because it is about this, too. */
  readonly isEcho?: boolean;
  readonly remedy?: Remedy;
  /** Sessions it has to do with. */
  readonly others?: readonly SessionRef[];
}
