import type { Init, ServiceReply } from '@ubii/proto';

/** The reply to one service request. */
export interface ServiceAnswer {
  readonly reply: Init<ServiceReply>;
  /** To be called once, when the reply was handed to the transport: what must not overtake the reply follows (TD-24). Never throws. */
  afterReply(): void;
  /** Seconds after which a request that was refused for want of room may be sent again. */
  readonly retryAfterS?: number;
}
