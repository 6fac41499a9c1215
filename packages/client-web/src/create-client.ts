import type { PatternSource } from '@ubii/patterns';
import { systemClock } from '@ubii/timing/system';
import { createConsoleErrors } from './console-errors.ts';
import type { ClientOptions } from './core/client/client-options.ts';
import { createUbiiClient } from './core/client/create-ubii-client.ts';
import type { UbiiClient } from './core/client/ubii-client.ts';
import { resolveEndpoints } from './endpoints.ts';
import { systemUuid } from './system-uuid.ts';
import { createHttpServices } from './transports/http.ts';
import { createWebSocketTopicData } from './transports/websocket.ts';
import type { OpenWebSocket } from './transports/websocket.ts';

/** A client over HTTP and WebSocket, except for the transports that the options bring. */
export function createClientOver(
  options: ClientOptions,
  patterns: PatternSource,
  openWebSocket: OpenWebSocket,
  defaultUrl: string | undefined,
): UbiiClient {
  const { clock = systemClock, random = Math.random, transports = {} } = options;
  const endpoints = () => resolveEndpoints(options, defaultUrl);
  return createUbiiClient(options, {
    clock,
    random,
    patterns,
    uuid: systemUuid,
    reportError: createConsoleErrors(),
    services: transports.services ?? createHttpServices({ url: endpoints().servicesUrl }),
    topicData:
      transports.topicData ?? createWebSocketTopicData(endpoints().topicDataUrl, openWebSocket),
  });
}
