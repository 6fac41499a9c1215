import type {
  DataFormat,
  DataFormatValues,
  DecodeError,
  Init,
  Mark,
  ServiceError,
  ServiceName,
  ServiceReplyOf,
  ServiceRequestOf,
  SERVICES,
} from '@ubii/proto';
import type { EncodedNodeMessage } from '@ubii/proto/wire';
import type { ClientCounters } from './client-counters.ts';
import type { ConnectionState } from '../connection/connection-state.ts';
import type { ComponentInit, DeviceInit, RegisteredDevice } from '../devices/devices.ts';
import type { EncodedListener } from '../subscriptions/encoded-record.ts';
import type { ClientRole } from '../connection/join.ts';
import type { ErrorHandler } from '../ports/error-handler.ts';
import type { PublishOptions } from '../publishing/publish-buffer.ts';
import type { ClientProfile } from '../connection/membership.ts';
import type { MasterChange } from '../connection/moves.ts';
import type { RoundTrip } from '../connection/round-trip.ts';
import type { SubscribeOptions, Subscription } from '../subscriptions/subscription.ts';
import type { MasterTime } from '../time/master-time.ts';
import type { TopicPattern } from '../subscriptions/topic-pattern.ts';
import type { Unsubscribe } from '../callbacks/unsubscribe.ts';

export type { Unsubscribe } from '../callbacks/unsubscribe.ts';

/** A change of the client's id: only an original master, or one that lost its key, causes it. */
export interface IdentityChange {
  readonly previousId: string;
  readonly clientId: string;
}

/**
 * Something went wrong that no promise reports: a frame that cannot be decoded, an error the master
 * sent over the topic-data channel (a refused record), or a device or subscription the master did
 * not take back after a reconnect.
 */
export type ClientProblem = DecodeError | ServiceError;

/** A program's place in a Ubi-Interact system: connection, topic data, services and devices. */
export interface UbiiClient {
  /**
   * Connects, and from then on keeps the connection until `close()`. While connecting or connected it
   * gives the promise of the connect under way.
   * @returns resolves with the first connection; rejects with the `ConnectionError` of a terminal `closed`
   */
  connect(): Promise<void>;
  /** Sends what is waiting, deregisters, ends all subscriptions and rejects pending calls; idempotent. */
  close(): Promise<void>;
  /**
   * Tells the master in passing that the client leaves, for a program that ends this moment: it is
   * removed at once, and not missed. What was published goes before. Identity, subscriptions and devices
   * are kept: the next `connect()`, or the next page of the tab, comes back as the same client. [EX-55]
   */
  leave(): void;
  /**
   * The way to the master may be free again, or gone: tries at once when waiting to reconnect, and
   * makes sure that a link which seems open is. [CL-41]
   */
  retryNow(): void;

  /**
   * Joins with a token or code, also when it has joined as something else before, and connects. A token
   * that is refused rejects with a `ConnectionError` whose reason is `join`; `state` then is `closed` with
   * the same error, unless it was connected: then it stays what it was.
   */
  join(token: string): Promise<void>;
  /**
   * Value of the header `Authorization` for requests to the master that are not service calls, such as for files of
   * recordings; `undefined` when the client joined without an invitation. It changes while the client is connected. [AC-13]
   */
  readonly authorization: string | undefined;
  /** Rights of the client; `undefined` before the first connection, and with masters that do not support roles. */
  readonly role: ClientRole | undefined;

  /** The client's id; empty before the first connection. */
  readonly id: string;
  /** Name for people. */
  readonly name: string;
  /** Its mark; `undefined` before the first connection unless one was given, and with original masters. [EX-100] */
  readonly mark: Init<Mark> | undefined;
  /**
   * Changes the name. The master learns it now, or as soon as it can be reached; an original master
   * when the client registers again. Rejects with the `ServiceError` when the master refuses it.
   */
  rename(name: string): Promise<void>;
  /**
   * Changes what the master knows of the client: name, description, tags, mark, and what it is as a node.
   * The master learns it as with `rename`.
   */
  updateProfile(change: Partial<ClientProfile>): Promise<void>;
  /** Calls `fn` after the master gave the client another id. */
  onIdentityChange(fn: (change: IdentityChange) => void): Unsubscribe;

  /**
   * Base URL of the master that the client is at, such as `http://10.0.0.5:8080`; another one after `onMaster`. Requests
   * that are not service calls go there. `undefined` when the options have transports and no `url`.
   */
  readonly masterUrl: string | undefined;
  /** Base URLs of the other masters of the cluster that this client could go to, as far as its master told. [CU-80] */
  readonly otherMasters: readonly string[];
  /** Calls `fn` when the client lost its master and went on at another one of the cluster, as itself. [CU-83] */
  onMaster(fn: (change: MasterChange) => void): Unsubscribe;

  readonly state: ConnectionState;
  /** Calls `fn` after every change of `state`. */
  onState(fn: (state: ConnectionState) => void): Unsubscribe;
  /** `undefined` before the first measurement, and with original masters. */
  readonly roundTrip: RoundTrip | undefined;
  /** Calls `fn` after every measurement, about every 2 s. */
  onRoundTrip(fn: (roundTrip: RoundTrip) => void): Unsubscribe;
  /** The master's clock, as far as it is known here. */
  readonly masterTime: MasterTime;
  /** Calls `fn` for problems of the connection and its data that no promise reports. */
  onError(fn: (problem: ClientProblem) => void): Unsubscribe;
  /** Reports an error to `onError` of the options: for libraries that call callbacks of a program. */
  readonly reportError: ErrorHandler;
  readonly counters: ClientCounters;
  /**
   * Bytes that were published and have not left yet: those that wait here, and those in the socket that the system has
   * not taken. A program that publishes much, such as a camera, sends its next record when this is near 0: what is in
   * the socket cannot be taken back, and whatever comes next is late by it.
   */
  readonly bufferedBytes: number;

  /**
   * Publishes a value on a topic. Records leave in the order of the calls. While there is no
   * connection the newest record of each topic is kept and sent after the reconnect, up to
   * `PUBLISH_LIMITS.awayTopics` topics; see README.
   * @throws {TypeError} if the topic is empty or the value does not fit the format
   */
  publish<F extends DataFormat>(
    topic: string,
    format: F,
    value: DataFormatValues[F],
    options?: PublishOptions,
  ): void;
  /**
   * Says that a topic has no value any more: publishes a record without a value, which takes the place of those that
   * wait, and which the master deletes within half a second. [TD-48]
   * @throws {TypeError} if the topic is empty
   */
  endTopic(topic: string): void;
  /** Changes how long records are collected before they are sent, milliseconds. */
  setPublishIntervalMs(intervalMs: number): void;

  /**
   * Subscribes to a topic or a pattern; may be called at any time, connected or not.
   * @throws {TypeError} if the pattern is empty or not a regular expression
   */
  subscribe<F extends DataFormat = DataFormat>(
    pattern: string | TopicPattern,
    options?: SubscribeOptions<F>,
  ): Subscription<F>;

  /**
   * Subscribes to encoded records, to forward them or to decode them elsewhere: they
   * are decoded here only if an ordinary subscription wants them, too. A large record that no other subscription
   * receives comes with its buffer (`isOwned`), without a copy. Records without a value come as `onGone`.
   * @returns ends the subscription
   * @throws {TypeError} if the pattern is empty or not a regular expression
   */
  subscribeEncoded(pattern: string | TopicPattern, listener: EncodedListener): Unsubscribe;
  /**
   * Publishes an encoded `TopicDataRecord`, unchecked. It leaves at the end of the turn, in the order
   * of the calls; else as with `publish`.
   * @param record of this topic; not changed later
   * @param valueField number of the value member, 0 when there is none
   */
  publishEncoded(topic: string, record: Uint8Array, valueField: number): void;
  /** Calls `fn` for what the master tells its nodes. [EX-20] */
  onNodeMessage(fn: (message: EncodedNodeMessage) => void): Unsubscribe;
  /**
   * Tells the master something as a node. Records published before arrive before it, unless the socket is full.
   * @param frame of `encodeNodeMessageFrame` or `encodeLockstepReplyFrame` of `@ubii/proto/wire`
   * @returns false when there is no connection to a master of ours
   */
  sendNodeMessage(frame: Uint8Array): boolean;

  /**
   * Calls a service of the master. Waits for the connection while there is none, as part of the
   * time-out. `clientId` is filled in where the request has such a member and it is empty.
   * Rejects with the `ServiceError` the master answered, or with a `ConnectionError`.
   */
  call<S extends ServiceName>(
    service: S,
    ...request: ServiceCallArguments<S>
  ): Promise<ServiceReplyOf<S>>;

  /** Registers a device with its components, and again after every reconnect. Waits for the connection. */
  registerDevice<const C extends readonly ComponentInit[]>(
    device: DeviceInit<C>,
  ): Promise<RegisteredDevice<C>>;
}

/** Arguments of `call` after the service's name: none, an optional or a required request. */
export type ServiceCallArguments<S extends ServiceName> = [ServiceRequestOf<S>] extends [undefined]
  ? []
  : (typeof SERVICES)[S]['requestRequired'] extends true
    ? [request: Init<ServiceRequestOf<S>>]
    : [request?: Init<ServiceRequestOf<S>>];
