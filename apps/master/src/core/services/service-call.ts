import type { Caller } from '../access/caller.ts';
import type { CallerFacts } from '../ports/caller-facts.ts';

/** Context of one call, besides its request. */
export interface ServiceCall {
  /** The caller. The router has checked its rights. */
  readonly caller: Caller;
  /** Unit by which wrong codes of this caller are counted. [AC-17] */
  readonly place: string;
  /** What the transport knows of the caller. */
  readonly facts: CallerFacts;
  /** Another master asks for its caller: what other masters have is not of interest [CU-29]. */
  readonly isOfMaster: boolean;
  /** True when the caller is on the machine of this master, without a proxy in between [AC-43]. */
  readonly isHere: boolean;
  /** Its address, where `place` is a network. */
  readonly address: string | undefined;
  /** Has `fn` called when the reply has left [TD-24]. */
  afterReply(fn: () => void): void;
  /** To be called between pieces of long work, and awaited when it took long: gives others a turn. */
  yieldToEventLoop(): Promise<void> | undefined;
}
