// What both entry points offer beside `createClient`.

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
export type { ClientCounters } from './core/client-counters.ts';
export type { ClientOptions } from './core/client-options.ts';
export type { ComponentProfile } from './core/component-profile.ts';
export { ConnectionError } from './core/connection-error.ts';
export type { ConnectionErrorReason } from './core/connection-error.ts';
export type { ConnectionState, ConnectionStatus } from './core/connection-state.ts';
export type {
  ComponentInit,
  DeviceInit,
  RegisteredComponent,
  RegisteredDevice,
} from './core/devices.ts';
export type { EncodedListener, EncodedRecord } from './core/encoded-record.ts';
export { createMemoryIdentity } from './core/identity.ts';
export type { Identity } from './core/identity.ts';
export { clientRole, joinProblem } from './core/join.ts';
export type { ClientRole, JoinProblem } from './core/join.ts';
export type { Cancel, Clock } from '@ubii/timing';
export { systemClock } from '@ubii/timing/system';
export type { ErrorHandler, ErrorSource } from './core/ports/error-handler.ts';
export type { IdentityStorage } from './core/ports/identity-storage.ts';
export type { RandomSource } from './core/ports/random.ts';
export type { ServiceExchange, ServiceTransport } from './core/ports/service-transport.ts';
export type {
  TopicDataHandler,
  TopicDataQuery,
  TopicDataSocket,
  TopicDataTransport,
} from './core/ports/topic-data-transport.ts';
export { PUBLISH_LIMITS } from './core/publish-buffer.ts';
export type { PublishOptions } from './core/publish-buffer.ts';
export { DEFAULT_RECONNECT_POLICY } from './core/reconnect-policy.ts';
export type { ReconnectPolicy } from './core/reconnect-policy.ts';
export type { ClientProfile } from './core/membership.ts';
export type { RoundTrip } from './core/round-trip.ts';
export type { SubscribeOptions, Subscription } from './core/subscription.ts';
export type { MasterTime, MasterTimeEstimate } from './core/time/master-time.ts';
export type { TopicPattern } from './core/topic-pattern.ts';
export type {
  ClientProblem,
  IdentityChange,
  ServiceCallArguments,
  UbiiClient,
  Unsubscribe,
} from './core/ubii-client.ts';
