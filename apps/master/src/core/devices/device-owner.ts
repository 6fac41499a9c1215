import type { Device } from '@ubii/proto';
import type { ClientAccess } from '../access/caller.ts';
import type { PublishRights } from '../topics/rights.ts';
import type { TopicOwner } from '../topics/topic-entry.ts';
import type { ClientSubscriber } from '../topics/subscriber.ts';

/** The client that a device belongs to, as devices need it. */
export interface DeviceOwner extends TopicOwner {
  readonly status: string;
  /** The master that it is connected to; undefined: this one. */
  readonly home: object | undefined;
  readonly access: ClientAccess;
  readonly subscriber: ClientSubscriber;
  readonly publishRights: PublishRights | undefined;
  /** By id. */
  readonly devices: Map<string, Device>;
  /** Grows with every change of its devices [EX-74]. */
  registrationRevision: number;
}
