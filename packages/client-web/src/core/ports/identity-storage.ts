/** Data that a client needs to resume as the same client. */
export interface Identity {
  /** The id the master gave. */
  readonly clientId: string;
  /** Proof that the id is ours; a secret. `undefined` with an original master. [EX-3] */
  readonly resumeToken: string | undefined;
  /** Secret of a joined client. `undefined` when the client does not need to join. [AC-13] */
  readonly credential?: string | undefined;
}

/** Stores one identity, so that a program or a page resumes as the same client. */
export interface IdentityStorage {
  /** Returns the stored identity, unless another client uses it. Called once, at the first connect. */
  load(): Identity | undefined | Promise<Identity | undefined>;
  /** Keeps `identity` in place of the earlier one; `undefined` forgets it. */
  save(identity: Identity | undefined): void;
  /**
   * The credential of an earlier client of the same person, such as that of another tab: a further client
   * joins with it. A storage for one client alone leaves this out. [AC-23]
   */
  loadCredential?(): string | undefined;
  /** The master takes this credential no more. */
  forgetCredential?(credential: string): void;
}
