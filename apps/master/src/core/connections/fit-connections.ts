import type { Limits } from '../limits/index.ts';

/** Descriptors of the program itself: files, workers, ports, and room for what is opened for a moment. */
const OWN_DESCRIPTORS = 128;
/** A connection and the file that is sent on it. */
const DESCRIPTORS_PER_CONNECTION = 2;
const MIN_CONNECTIONS = 16;

/**
 * Limits on connections that the process can keep: lower ones where it may open less, in the same
 * proportions to each other. [AC-60]
 *
 * @param descriptors how many the process may have open; undefined when the system sets no limit
 */
export function fitConnections(limits: Limits, descriptors: number | undefined): Limits {
  const able =
    descriptors === undefined
      ? limits.connections
      : Math.floor((descriptors - OWN_DESCRIPTORS) / DESCRIPTORS_PER_CONNECTION);
  const connections = Math.max(MIN_CONNECTIONS, Math.min(limits.connections, able));
  const connectionsOfStrangers = lower(limits.connectionsOfStrangers, connections / 2);
  return {
    ...limits,
    connections,
    connectionsOfStrangers,
    connectionsPerNetwork: lower(limits.connectionsPerNetwork, (connectionsOfStrangers * 3) / 4),
    connectionsPerAddress: lower(limits.connectionsPerAddress, connectionsOfStrangers / 2),
  };
}

function lower(limit: number, most: number): number {
  return Math.max(1, Math.min(limit, Math.floor(most)));
}
