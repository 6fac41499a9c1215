import type { Caller } from '../access/caller.ts';

/** Context of one call, besides its request. */
export interface ServiceCall {
  /** The caller. The router has checked its rights. */
  readonly caller: Caller;
  /** Unit by which wrong codes of this caller are counted. [AC-17] */
  readonly place: string;
  /** True when the caller is on this machine, without a proxy in between [AC-43]. */
  readonly isHere: boolean;
  /** Its address, where `place` is a network. */
  readonly address: string | undefined;
  /** Has `fn` called when the reply has left [TD-24]. */
  afterReply(fn: () => void): void;
  /** To be called between pieces of long work, and awaited when it took long: gives others a turn. */
  yieldToEventLoop(): Promise<void> | undefined;
}
