/** Network between the masters of a run, whose links can be cut. */
export interface ClusterNetwork {
  /** In words, for the report. */
  readonly about: string;
  /** Address on which NATS listens. */
  readonly natsHost: string;
  /** Opens the links to NATS; called before `natsUrl`. */
  openLinks(natsPort: number): Promise<void>;
  /** NATS as a master reaches it. @param index of the master */
  natsUrl(index: number): string;
  /** Command that starts a program on the machine of this master. */
  within(index: number): readonly string[];
  /** Address by which clients reach a master. */
  hostOf(index: number): string;
  /** Flags of a master that say where it listens. */
  readonly listenFlags: readonly string[];
  /** Cuts a master, with the clients of its machine, off from NATS and the other masters. */
  cut(index: number): void;
  heal(index: number): void;
  close(): Promise<void>;
}
