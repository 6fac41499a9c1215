/** Where the masters of a run are, and how the way between them is cut. */
export interface Ground {
  /** In words, for the report. */
  readonly about: string;
  /** Address on which NATS listens. */
  readonly natsHost: string;
  /** Says where NATS listens, before the first `natsUrl`. */
  openWays(natsPort: number): Promise<void>;
  /** NATS as a master reaches it. @param index of the master */
  natsUrl(index: number): string;
  /** Words of the command that a program of this master's machine is started by. */
  within(index: number): readonly string[];
  /** Address by which clients reach a master. */
  hostOf(index: number): string;
  /** Flags of a master that say where it listens. */
  readonly network: readonly string[];
  /** Cuts a master, with the clients of its machine, off from NATS and the other masters. */
  cut(index: number): void;
  heal(index: number): void;
  close(): Promise<void>;
}
