import type { TestCluster } from '../cluster.ts';

/** A fault of a cluster, which one phase of a run injects. */
export interface Fault {
  /** For `--only`. */
  readonly name: string;
  readonly about: string;
  /** The storage of NATS is lost, and with it the documents that no master has open. */
  readonly losesStorage?: boolean;
  /** Injects the fault and repairs it; resolves when nothing is broken any more. @param say prints what happens */
  run(cluster: TestCluster, say: (text: string) => void): Promise<void>;
  /**
   * Whether records may be lost between a publisher and a subscriber whose clients were at these masters when it began
   * and stayed there, by the specification of clusters.
   */
  mayLose(publisherAt: number, subscriberAt: number): boolean;
}
