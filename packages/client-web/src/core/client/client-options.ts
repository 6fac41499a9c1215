import type { Init, Mark, NodeExtension, ProcessingModule } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import type { ErrorHandler } from '../ports/error-handler.ts';
import type { IdentityStorage } from '../ports/identity-storage.ts';
import type { WaysTo } from '../ports/master-ways.ts';
import type { RandomSource } from '../ports/random.ts';
import type { ServiceTransport } from '../ports/service-transport.ts';
import type { TopicDataTransport } from '../ports/topic-data-transport.ts';
import type { ReconnectPolicy } from '../connection/reconnect-policy.ts';

/** Options of a client. */
export interface ClientOptions {
  /** Origin of a master, such as `http://localhost:8080`. @default the page's origin; required in Node */
  readonly url?: string;
  /** URL of services, if not under `url`; JSON when the path ends with `/json` or `/services`, otherwise binary. */
  readonly servicesUrl?: string;
  /** URL of the topic-data WebSocket, if not under `url`. */
  readonly topicDataUrl?: string;
  /** Name for people; need not be unique. */
  readonly name: string;
  readonly description?: string;
  readonly tags?: readonly string[];
  /** Capabilities of the client as a node; undefined for a client that runs no modules. [PM-60] */
  readonly node?: Init<NodeExtension>;
  /** The modules it has code for; their code need not be told. [PM-60] */
  readonly processingModules?: readonly Init<ProcessingModule>[];
  /** True when it exists to run modules for others. @default false */
  readonly isDedicatedNode?: boolean;
  /** Shape and colour that people know it by. @default the master gives it one that is free [EX-100] */
  readonly mark?: Init<Mark>;
  /**
   * Token or code to join with, if the master requires one. Used for the first registration;
   * then the credential, which is kept with the identity, identifies it. [AC-13]
   */
  readonly joinToken?: string;
  /** Storage of the identity between runs. @default in memory */
  readonly identity?: IdentityStorage;
  /** Records are collected this long and sent as one frame, milliseconds; 0: until the end of the turn. @default 15 */
  readonly publishIntervalMs?: number;
  /** Use the master's time instead of this machine's for records without a timestamp. [TS-9] @default false */
  readonly stampInMasterTime?: boolean;
  /** A service call, and each step of connecting, may take this long, milliseconds. @default 10000 */
  readonly serviceTimeoutMs?: number;
  /** When to try again after the link failed. @default see DEFAULT_RECONNECT_POLICY */
  readonly reconnect?: Partial<ReconnectPolicy>;
  /**
   * Called with errors of the program's own code: of its callbacks, asynchronous ones included, and of the
   * storage of the identity. None of them ends the connection or the process. Problems of the connection and
   * its data go to `client.onError`. @default writes each error to the console, equal ones once
   */
  readonly onError?: ErrorHandler;
  /** @default the system's clock */
  readonly clock?: Clock;
  /** @default Math.random */
  readonly random?: RandomSource;
  /** Ways to the master, each in place of the usual one: HTTP for services, WebSocket for topic data. */
  readonly transports?: {
    readonly services?: ServiceTransport;
    readonly topicData?: TopicDataTransport;
    /** Ways to another master of the cluster. @default HTTP and WebSocket, unless there are own ways to the first one */
    readonly waysTo?: WaysTo;
  };
}
