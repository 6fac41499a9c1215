import fastify from 'fastify';
import type { FastifyInstance } from 'fastify';

import type { Master } from '../../core/master.ts';
import type { Log } from '../../core/ports/index.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import type { OriginPolicy } from '../network/origin-policy.ts';
import { addAuthority, addAuthorityFacts } from './authority-routes.ts';
import { guardOrigins } from './cross-origin.ts';
import { replyErrors } from './error-replies.ts';
import { addFrontend } from './frontend.ts';
import { RequestCounts } from './request-counts.ts';
import { addServices } from './services-routes.ts';
import { addStatus } from './status-routes.ts';

export interface HttpAppOptions {
  readonly master: Master;
  readonly policy: OriginPolicy;
  readonly callers: CallerReader;
  readonly log: Log;
  readonly name: string;
  readonly version: string;
  /** Largest service request. */
  readonly maxRequestBytes: number;
  /** The built frontend. */
  readonly frontendFolder: string;
  /** Certificate of the master's own authority, PEM; undefined when it has none. */
  readonly authority: string | undefined;
}

/** Everything the master answers over HTTP. It listens nowhere: `routing` takes requests of any server. */
export async function createHttpApp(options: HttpAppOptions): Promise<FastifyInstance> {
  const { master, policy, callers, log, maxRequestBytes, frontendFolder } = options;
  const app = fastify({
    logger: false,
    bodyLimit: maxRequestBytes,
    routerOptions: { ignoreTrailingSlash: true },
    // Requests that arrive while the master ends are answered as long as their socket stands.
    return503OnClosing: false,
  });
  const counts = new RequestCounts();
  app.addHook('onResponse', (request, reply, done) => {
    counts.count(request.routeOptions.url, reply.statusCode);
    done();
  });
  guardOrigins(app, policy);
  replyErrors(app, log);
  addServices(app, { master, callers, maxRequestBytes });
  addStatus(app, { ...options, edgeMetrics: () => counts.metrics() });
  addAuthorityFacts(app, options.authority);
  if (options.authority !== undefined) addAuthority(app, options.authority);
  await addFrontend(app, frontendFolder);
  await app.ready();
  return app;
}
