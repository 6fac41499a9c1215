import type { TestCluster } from '../cluster.ts';

/** What is done to a cluster in one part of a run. */
export interface Fault {
  /** For `--only`. */
  readonly name: string;
  readonly about: string;
  /** The storage of NATS is lost, and with it the documents that no master has open. */
  readonly losesStorage?: boolean;
  /** Does it, and takes it back. Resolves when nothing is broken any more. @param say what happens, for the report */
  run(cluster: TestCluster, say: (text: string) => void): Promise<void>;
  /**
   * Whether records may be lost between a publisher and a subscriber whose clients were at these masters when it began
   * and stayed there, by the specification of clusters.
   */
  mayLose(publisherAt: number, subscriberAt: number): boolean;
}
