/** Topics on which a client may publish; undefined instead of it: all. [AC-24] */
export interface PublishRights {
  mayPublish(topic: string): boolean;
  /** Whether it may say besides, on the topic for that, that it is gone itself. */
  readonly maySayFarewell: boolean;
}

/** Topics that a client may receive; undefined instead of it: all topics [AC-25]. */
export interface ReadRights {
  mayRead(topic: string): boolean;
}
