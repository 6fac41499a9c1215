/**
 * Who calls, as far as the transport can tell: `local`, this machine itself; `network`, one of the
 * networks that are let in without a token; `other`, everybody else [AC-1] [AC-4] [AC-5].
 */
export type CallerStanding = 'local' | 'network' | 'other';

/** What a transport knows of the one who calls or connects. */
export interface CallerFacts {
  readonly standing: CallerStanding;
  /** Where wrong codes are counted for: its address, or the network that one person has [AC-17]. */
  readonly place: string;
  /** What follows `Bearer` in its header `Authorization`; undefined when it sent none [AC-3]. */
  readonly bearer: string | undefined;
}

/** A caller of this machine, without a token. */
export const LOCAL_CALLER: CallerFacts = { standing: 'local', place: 'here', bearer: undefined };
