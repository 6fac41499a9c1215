import type { JoinProblem } from './join.ts';

/**
 * Why a link failed: `closed`: by us, by the master, or it broke · `refused`: by the master, or
 * the master is down · `timeout` · `protocol`: what came makes no sense · `superseded`: another socket
 * uses this identity now · `disconnected`: an admin removed this client, the message says who and why
 * · `join`: the client has to join first, or again; `joinProblem` says why.
 */
export type ConnectionErrorReason =
  | 'closed'
  | 'refused'
  | 'timeout'
  | 'protocol'
  | 'superseded'
  | 'disconnected'
  | 'join';

/** The link to the master failed. */
export class ConnectionError extends Error {
  override readonly name = 'ConnectionError';
  readonly reason: ConnectionErrorReason;

  /** Set when the reason is `join`. */
  readonly joinProblem: JoinProblem | undefined;

  constructor(
    reason: ConnectionErrorReason,
    message: string,
    options?: { cause?: unknown; joinProblem?: JoinProblem },
  ) {
    super(message, options);
    this.reason = reason;
    this.joinProblem = options?.joinProblem;
  }
}
