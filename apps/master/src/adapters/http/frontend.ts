import { existsSync } from 'node:fs';
import { join } from 'node:path';
import fastifyStatic from '@fastify/static';
import type { FastifyInstance, FastifyReply, FastifyRequest } from 'fastify';
import { SANDBOX_WORKER_FILES } from '@ubii/pm-sandbox';
import { ServiceError } from '@ubii/proto';
import { contentSecurityPolicy } from './security-headers.ts';

/** Shown where the frontend should be, when it is not there. */
const NOT_BUILT_PAGE = `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Ubi-Interact: the frontend is not built</title>
<style>
  :root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; }
  body { max-width: 36rem; margin: 15vh auto; padding: 0 1.5rem; }
  code { font: 0.9em ui-monospace, monospace; }
</style>
<h1>The frontend is not built</h1>
<p>This master runs: services and topic data work. Its pages are missing.</p>
<p>Stop it and run <code>npm start</code>, which builds what is missing. While working on the
frontend, run <code>npm run dev</code> and open the address it prints for pages.</p>
</html>
`;

/** Files under this path carry a hash of their content in their name. */
const HASHED = '/assets/';
const ONE_YEAR = 'public, max-age=31536000, immutable';
/** Asks each time; the answer is usually "not modified". */
const ASK_FIRST = 'no-cache';

/**
 * Serves the built frontend. Paths of pages are the frontend's own: they all get its one document.
 *
 * @param folder the built frontend; where there is none, a page says so
 * @param clusterOrigins of the other masters [CU-91]
 */
export async function addFrontend(
  app: FastifyInstance,
  folder: string,
  clusterOrigins: () => readonly string[],
): Promise<void> {
  const isBuilt = existsSync(join(folder, 'index.html'));
  if (isBuilt) {
    await app.register(fastifyStatic, {
      root: folder,
      // The build puts a compressed copy beside each file that gets smaller by it.
      preCompressed: true,
      cacheControl: false,
      setHeaders: (reply, path) => {
        const name = path.slice(folder.length).replaceAll('\\', '/');
        const others = clusterOrigins();
        reply.header('content-security-policy', policyOf(name, others));
        reply.header('cache-control', cachingOf(name, others.length > 0));
      },
    });
  }
  app.setNotFoundHandler((request, reply) => {
    if (!isPageRequest(request)) throw explainMissing(request);
    return isBuilt ? reply.sendFile('index.html') : sendNotBuilt(reply);
  });
}

/** Workers with modules get a stricter policy than pages. Compressed copies have longer names. */
function policyOf(name: string, others: readonly string[]): string {
  const worker = Object.values(SANDBOX_WORKER_FILES).find(({ path }) => name.startsWith(path));
  return worker?.csp ?? contentSecurityPolicy(others);
}

/** Browsers keep the policy of a page that was not modified, whatever comes with that answer. */
function cachingOf(name: string, isInCluster: boolean): string {
  if (name.startsWith(HASHED)) return ONE_YEAR;
  return isInCluster && /\.html(\.[a-z]+)?$/.test(name) ? 'no-store' : ASK_FIRST;
}

/**
 * Browsers ask for a page with `text/html`; what has an extension is a file. `/services` alone is what people type who
 * look for the page of the services; below it, clients call them.
 */
function isPageRequest({ method, headers, url }: FastifyRequest): boolean {
  const path = pathOf(url);
  return (
    (method === 'GET' || method === 'HEAD') &&
    (headers.accept ?? '').includes('text/html') &&
    !/^\/(services\/|sdk(\/|$)|topicdata(\/|$))/.test(path) &&
    !/\.[a-z0-9]+$/i.test(path)
  );
}

function explainMissing({ method, url }: FastifyRequest): ServiceError {
  const path = pathOf(url).slice(0, 200);
  if (path.startsWith('/services')) {
    return new ServiceError(
      'not_found',
      `Services are called by POST to /services/json, /services/binary or /services, not by ${method} ${path}.`,
    );
  }
  if (path.startsWith('/topicdata')) {
    return new ServiceError(
      'not_found',
      'Topic data is a WebSocket: open it as ws://, with ?clientID=<id>.',
    );
  }
  return new ServiceError('not_found', `No page or service exists at ${path}.`);
}

function sendNotBuilt(reply: FastifyReply): FastifyReply {
  return reply
    .code(503)
    .header('content-security-policy', contentSecurityPolicy([]))
    .header('cache-control', 'no-store')
    .type('text/html; charset=utf-8')
    .send(NOT_BUILT_PAGE);
}

function pathOf(url: string): string {
  return url.split('?', 1)[0] ?? '';
}
