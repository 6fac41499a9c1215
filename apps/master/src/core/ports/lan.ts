/** The networks that can reach the ports of the master. */
export interface Lan {
  /** Other machines can reach the master. */
  readonly isOpen: boolean;
  /**
   * Listens on all networks of this machine, with the rights, certificate and limits of `--lan on`. Does nothing when
   * it is open.
   *
   * @throws Error when a port cannot be had; everything is as before then
   */
  open(): Promise<void>;
}
