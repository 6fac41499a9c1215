/** Invitations that the terminal shows. */
export interface TerminalJoin {
  readonly token: string;
  readonly code: string;
  /** Epoch milliseconds. */
  readonly expiresMs: number;
}

/** Tokens and codes that the terminal of a run shows. */
export interface TerminalAccess {
  /** For the operator, on this machine [AC-42]. */
  readonly admin: TerminalJoin;
  /** For participants; undefined when no other machine can reach the master [AC-19]. */
  readonly join: TerminalJoin | undefined;
}
