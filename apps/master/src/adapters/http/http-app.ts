import type { IncomingMessage } from 'node:http';
import fastify from 'fastify';
import type { FastifyInstance } from 'fastify';
import type { AssetFolders } from '@ubii/pm-sandbox/node';
import type { Clock } from '@ubii/timing';
import type { MasterMetrics, Master } from '../../core/master/master.ts';
import type { Limits } from '../../core/limits/index.ts';
import type { Log } from '../../core/ports/index.ts';
import type { CallerReader } from '../access/caller-reader.ts';
import type { ConnectionGuard } from '../network/connection-guard.ts';
import type { OriginPolicy } from '../network/origin-policy.ts';
import { addAssets } from './asset-routes.ts';
import { addAuthority, addAuthorityFacts } from './authority-routes.ts';
import type { BodyDecoder } from '../services/bodies/body-decoder.ts';
import { drain } from '../services/bodies/drain.ts';
import { guardOrigins, guardPaths } from './request-guards.ts';
import { replyErrors } from './error-replies.ts';
import { addFrontend } from './frontend.ts';
import { addRecordings } from './recording-routes.ts';
import { addSdk } from './sdk-routes.ts';
import { addServices } from './services-routes.ts';
import { addStatus } from './status-routes.ts';

/** Counts responses by route and class of status: names of our own, never what a client sent. */
class RequestCounts {
  readonly #counts = new Map<string, { route: string; status: string; count: number }>();

  /** @param route path of the route that answered; undefined when none did */
  count(route: string | undefined, statusCode: number): void {
    const status = `${Math.floor(statusCode / 100)}xx`;
    const key = `${route} ${status}`;
    const entry = this.#counts.get(key);
    if (entry) entry.count += 1;
    else this.#counts.set(key, { route: route ?? 'none', status, count: 1 });
  }

  metrics(): MasterMetrics {
    return [
      {
        name: 'ubii_http_responses_total',
        help: 'HTTP responses by route and class of status.',
        kind: 'counter',
        values: [...this.#counts.values()].map(({ route, status, count }) => ({
          labels: { route, status },
          value: count,
        })),
      },
    ];
  }
}

interface HttpAppContext {
  readonly master: Master;
  readonly policy: OriginPolicy;
  /** Origins of the other masters of the cluster. */
  readonly clusterOrigins: () => readonly string[];
  readonly callers: CallerReader;
  readonly log: Log;
  readonly name: string;
  readonly version: string;
  readonly clock: Clock;
  readonly limits: Limits;
  readonly decoder: BodyDecoder;
  readonly connectionGuard: ConnectionGuard;
  /** The built frontend. */
  readonly frontendFolder: string;
  /** The built client library. */
  readonly sdkFolder: string;
  readonly assets: AssetFolders;
  /** Path of the folder of the recordings. */
  readonly recordingsFolder: string;
  /** Certificate of the master's own authority, PEM; undefined while it has none. */
  readonly authority: () => string | undefined;
}

/** Ends the connection of a request that was answered and still goes on. [AC-65] */
async function cutUnread(raw: IncomingMessage, clock: Clock): Promise<void> {
  await drain(raw, clock);
  if (!raw.complete) raw.socket.destroy();
}

/** Everything the master answers over HTTP. It listens nowhere: `routing` takes requests of any server. */
export async function createHttpApp(context: HttpAppContext): Promise<FastifyInstance> {
  const { master, callers, policy, log, frontendFolder } = context;
  const app = fastify({
    logger: false,
    routerOptions: { ignoreTrailingSlash: true },
    // Requests that arrive while the master ends are answered as long as their socket stands.
    return503OnClosing: false,
  });
  const counts = new RequestCounts();
  app.addHook('onResponse', (request, reply, done) => {
    counts.count(request.routeOptions.url, reply.statusCode);
    void cutUnread(request.raw, context.clock);
    done();
  });
  // All handlers below need the caller.
  app.addHook('onRequest', ({ raw }, _reply, done) => {
    const prepared = callers.prepare(raw);
    if (prepared === undefined) done();
    else void prepared.then(() => done());
  });
  guardOrigins(app, { policy, master, callers });
  guardPaths(app, { master, callers });
  replyErrors(app, log);
  addServices(app, context);
  addStatus(app, { ...context, edgeMetrics: () => counts.metrics() });
  addAuthorityFacts(app, context.authority);
  addAuthority(app, context.authority);
  addAssets(app, context.assets);
  addRecordings(app, context);
  await addSdk(app, context.sdkFolder);
  await addFrontend(app, frontendFolder, context.clusterOrigins);
  await app.ready();
  return app;
}
