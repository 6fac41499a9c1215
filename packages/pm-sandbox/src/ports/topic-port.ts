import type { Component } from '@ubii/proto';
import type { Cancel } from '@ubii/timing';

/** Selects topics. */
export type TopicSelector =
  | { readonly kind: 'topic'; readonly topic: string }
  /** Regular expression, unanchored, case-sensitive. */
  | { readonly kind: 'regex'; readonly source: string }
  /** `*` within a level, `**` anything, `?` one character; the whole topic. */
  | { readonly kind: 'glob'; readonly glob: string }
  /** The publisher topics of all components that match the profile, of later ones as well. */
  | { readonly kind: 'component'; readonly profile: Component };

/** A record as it travels. */
export interface EncodedRecord {
  readonly topic: string;
  /** The encoded `TopicDataRecord`. It is not modified, and may be kept. */
  readonly bytes: Uint8Array;
  /** Number of the value member, 0 when there is none. */
  readonly valueField: number;
  /** Id of the client that published it; empty when it is not known. */
  readonly publisherId: string;
  /** Id of the device that has a component with this topic, if it is known. */
  readonly deviceId?: string;
  /** True: the buffer of `bytes` is not shared, so that it may be transferred. */
  readonly isOwned?: boolean;
}

/** Takes what a subscription yields. */
export interface TopicListener {
  onRecord(record: EncodedRecord): void;
  /** The value of the topic was deleted. */
  onGone(topic: string): void;
}

/** Topics as the runtime sees them: the master's store and a client each are one. */
export interface TopicPort {
  /**
   * Records of the selected topics from now on. Values that are there are handed to `onRecord` before
   * this returns, or as soon as they are known.
   * @throws Error with a sentence when the selector is refused
   */
  subscribe(selector: TopicSelector, listener: TopicListener): Cancel;
  /**
   * Publishes a complete encoded `TopicDataRecord`, which is the port's from now on.
   * @param sessionId the session of the module that put it out
   * @returns a sentence when it was refused
   */
  publish(
    topic: string,
    record: Uint8Array,
    valueField: number,
    sessionId: string,
  ): string | undefined;
  /**
   * A demuxer is about to write a topic for the first time. Without it, everybody may. [SE-61]
   * @returns why the session may not, as a sentence without its end
   */
  makeTopic?(topic: string, sessionId: string): string | undefined;
  /** Topics that were made, each as often as here, are not written any more: their values end. [SE-62] */
  endTopics?(topics: readonly string[], sessionId: string): void;
}
