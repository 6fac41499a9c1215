import { rootLabel } from './topic-path.ts';

/** Properties of a client that the tree needs. */
export interface Publisher {
  readonly name: string;
  /** The client is inactive, or has left. */
  readonly isAway: boolean;
  /** The list of clients has it: neither a master nor a client that has left. */
  readonly isClient?: boolean;
  /** Name of its master; empty unless there are several. */
  readonly master?: string;
}

/** Finds a client by its id. */
export type FindPublisher = (clientId: string) => Publisher | undefined;

/** True when the client of a topic, or the client that published last, is away. */
export function isPublisherAway(
  topic: string,
  publisherId: string,
  findPublisher: FindPublisher,
): boolean {
  return [rootLabel(topic), publisherId].some((id) => findPublisher(id)?.isAway);
}
