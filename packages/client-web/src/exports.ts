// Exports of both entry points besides `createClient`.

export { DecodeError, ServiceError } from '@ubii/proto';
export type {
  DataFormat,
  DataFormatValues,
  ServiceErrorCode,
  ServiceName,
  ServiceReplyOf,
  ServiceRequestOf,
  TopicRecord,
} from '@ubii/proto';
export type { ClientCounters } from './core/client/client-counters.ts';
export type { ClientOptions } from './core/client/client-options.ts';
export type { ComponentProfile } from './core/subscriptions/component-profile.ts';
export { ConnectionError } from './core/connection/connection-error.ts';
export type { ConnectionErrorReason } from './core/connection/connection-error.ts';
export type { ConnectionState, ConnectionStatus } from './core/connection/connection-state.ts';
export type { MasterChange } from './core/connection/moves.ts';
export type {
  ComponentInit,
  DeviceInit,
  RegisteredComponent,
  RegisteredDevice,
} from './core/devices/devices.ts';
export { connectOnce } from './connect-once.ts';
export type { EncodedListener, EncodedRecord } from './core/subscriptions/encoded-record.ts';
export { createMemoryIdentity } from './core/connection/identity.ts';
export type { Identity } from './core/connection/identity.ts';
export { explainConnectionError } from './core/connection/explain-connection-error.ts';
export { clientRole, joinProblem } from './core/connection/join.ts';
export type { ClientRole, JoinProblem } from './core/connection/join.ts';
export type { Cancel, Clock } from '@ubii/timing';
export { systemClock } from '@ubii/timing/system';
export type { ErrorHandler, ErrorSource } from './core/ports/error-handler.ts';
export type { IdentityStorage } from './core/ports/identity-storage.ts';
export type { MasterWays, WaysTo } from './core/ports/master-ways.ts';
export type { RandomSource } from './core/ports/random.ts';
export type { ServiceExchange, ServiceTransport } from './core/ports/service-transport.ts';
export type {
  TopicDataHandler,
  TopicDataQuery,
  TopicDataSocket,
  TopicDataTransport,
} from './core/ports/topic-data-transport.ts';
export { PUBLISH_LIMITS } from './core/publishing/publish-buffer.ts';
export type { PublishOptions } from './core/publishing/publish-buffer.ts';
export { DEFAULT_RECONNECT_POLICY } from './core/connection/reconnect-policy.ts';
export type { ReconnectPolicy } from './core/connection/reconnect-policy.ts';
export type { ClientProfile } from './core/connection/membership.ts';
export type { RoundTrip } from './core/connection/round-trip.ts';
export type { SubscribeOptions, Subscription } from './core/subscriptions/subscription.ts';
export type { MasterTime, MasterTimeEstimate } from './core/time/master-time.ts';
export type { TopicPattern } from './core/subscriptions/topic-pattern.ts';
export type {
  ClientProblem,
  IdentityChange,
  ServiceCallArguments,
  UbiiClient,
  Unsubscribe,
} from './core/client/ubii-client.ts';
