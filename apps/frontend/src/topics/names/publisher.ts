import { rootLabel } from './topic-path.ts';

/** What the tree needs to know of a client. */
export interface Publisher {
  readonly name: string;
  /** It has not been active lately, or left. */
  readonly isAway: boolean;
}

/** Finds a client by its id. */
export type FindPublisher = (clientId: string) => Publisher | undefined;

/** True when the client of a topic, or the client that published on it last, is away. */
export function isPublisherAway(
  topic: string,
  publisherId: string,
  findPublisher: FindPublisher,
): boolean {
  return [rootLabel(topic), publisherId].some((id) => findPublisher(id)?.isAway);
}
