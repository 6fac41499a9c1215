import type { PatternSource } from '@ubii/patterns';
import type { ClientOptions } from './core/client-options.ts';
import { createUbiiClient } from './core/create-ubii-client.ts';
import type { UbiiClient } from './core/ubii-client.ts';
import { resolveEndpoints } from './endpoints.ts';
import { systemClock } from './system-clock.ts';
import { systemUuid } from './system-uuid.ts';
import { createHttpServices } from './transports/http.ts';
import { createWebSocketTopicData } from './transports/websocket.ts';
import type { OpenWebSocket } from './transports/websocket.ts';

/** A client over HTTP and WebSocket, unless the options bring other transports. */
export function createClientOver(
  options: ClientOptions,
  patterns: PatternSource,
  openWebSocket: OpenWebSocket,
  defaultUrl: string | undefined,
): UbiiClient {
  const { clock = systemClock, random = Math.random, transports } = options;
  if (transports !== undefined) {
    return createUbiiClient(options, {
      clock,
      random,
      patterns,
      uuid: systemUuid,
      ...transports,
    });
  }
  const { servicesUrl, topicDataUrl } = resolveEndpoints(options, defaultUrl);
  return createUbiiClient(options, {
    clock,
    random,
    patterns,
    uuid: systemUuid,
    services: createHttpServices({ url: servicesUrl }),
    topicData: createWebSocketTopicData(topicDataUrl, openWebSocket),
  });
}
