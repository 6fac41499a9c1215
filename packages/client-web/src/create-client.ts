import type { PatternSource } from '@ubii/patterns';
import { systemClock } from '@ubii/timing/system';
import { createConsoleErrors } from './console-errors.ts';
import type { ClientOptions } from './core/client/client-options.ts';
import { createUbiiClient } from './core/client/create-ubii-client.ts';
import type { UbiiClient } from './core/client/ubii-client.ts';
import type { WaysTo } from './core/ports/master-ways.ts';
import { resolveEndpoints, type Endpoints } from './endpoints.ts';
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
  const servicesAt = ({ servicesUrl }: Endpoints) => createHttpServices({ url: servicesUrl });
  const topicDataAt = ({ topicDataUrl }: Endpoints) =>
    createWebSocketTopicData(topicDataUrl, openWebSocket);
  const waysTo: WaysTo = (url) => {
    const other = resolveEndpoints({ url }, undefined);
    return { services: servicesAt(other), topicData: topicDataAt(other) };
  };
  const hasOwnWays = transports.services !== undefined || transports.topicData !== undefined;
  const toOthers = transports.waysTo ?? (hasOwnWays ? undefined : waysTo);
  return createUbiiClient(options, {
    clock,
    random,
    patterns,
    uuid: systemUuid,
    reportError: createConsoleErrors(),
    master: {
      url: urlOf(options, defaultUrl),
      services: transports.services ?? servicesAt(endpoints()),
      topicData: transports.topicData ?? topicDataAt(endpoints()),
    },
    ...(toOthers && { waysTo: toOthers }),
  });
}

/** Base URL of the master; `undefined` when the options name only where its services and its topic data are. */
function urlOf(
  { url, servicesUrl, topicDataUrl }: ClientOptions,
  defaultUrl: string | undefined,
): string | undefined {
  const isNamed = servicesUrl !== undefined && topicDataUrl !== undefined;
  return (url ?? (isNamed ? undefined : defaultUrl))?.replace(/\/+$/, '');
}
