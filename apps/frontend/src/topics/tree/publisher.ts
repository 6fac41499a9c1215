/** What the tree needs to know of a client. */
export interface Publisher {
  readonly name: string;
  /** It gave no sign of life lately, or left. */
  readonly isAway: boolean;
}

/** Finds a client by its id. */
export type FindPublisher = (clientId: string) => Publisher | undefined;
