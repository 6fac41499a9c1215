import type { ServiceTransport } from './service-transport.ts';
import type { TopicDataTransport } from './topic-data-transport.ts';

/** Ways to one master. */
export interface MasterWays {
  readonly services: ServiceTransport;
  readonly topicData: TopicDataTransport;
}

/** A master and the ways to it. */
export interface MasterAt extends MasterWays {
  /** Base URL, such as `http://10.0.0.5:8080`; `undefined` when only the ways are known. */
  readonly url: string | undefined;
}

/** Makes the ways to another master of the cluster. Opens nothing yet. */
export type WaysTo = (url: string) => MasterWays;
