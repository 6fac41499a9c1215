import { existsSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import fastifyStatic from '@fastify/static';
import type { FastifyInstance, FastifyRequest } from 'fastify';
import { ServiceError } from '@ubii/proto';

/** A file of the client library. */
interface SdkFile {
  readonly name: string;
  readonly about: string;
  readonly sizeBytes: number;
}

/**
 * Page that lists the files of the client library, with one line to install and one to import it.
 *
 * @param origin of the master, as the caller reached it
 */
function sdkPage(origin: string, files: readonly SdkFile[]): string {
  const base = `${escapeHtml(origin)}/sdk`;
  const archive = files.find(({ name }) => name.endsWith('.tgz'))?.name ?? '';
  const rows = files.map(
    ({ name, about, sizeBytes }) =>
      `<tr><td><a href="/sdk/${name}">${name}</a><td>${about}<td>${Math.ceil(sizeBytes / 1000)} kB`,
  );
  return `<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>Ubi-Interact: client library</title>
<style>
  :root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; }
  body { max-width: 44rem; margin: 10vh auto; padding: 0 1.5rem; }
  td { padding: 0.25rem 1.5rem 0.25rem 0; }
  td:last-child { white-space: nowrap; }
  pre { overflow: auto; font: 0.9em ui-monospace, monospace; }
</style>
<h1>Client library</h1>
<p>Programs publish and subscribe with it. It has the version of this master.</p>
<p>In a project for Node 20.19 or newer:</p>
<pre>npm i ${base}/${archive}</pre>
<p>In a page, without a build:</p>
<pre>import { createClient } from '${base}/ubii-client.js';</pre>
<table>
${rows.join('\n')}
</table>
<p>The package has a README with examples. <a href="/learn/own-program">Lesson</a></p>
</html>
`;
}

function escapeHtml(text: string): string {
  return text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');
}

/** Routes of the client library. */
export const SDK_ROUTES = { page: '/sdk', files: '/sdk/*' } as const;

/** What each file is, by the end of its name. No other files are served. */
const KINDS: readonly (readonly [end: string, type: string, about: string])[] = [
  ['.tgz', 'application/gzip', 'package for Node and bundlers'],
  ['.js', 'text/javascript; charset=utf-8', 'ES module for pages'],
  // Without a type of its own at IANA; browsers show text.
  ['.d.ts', 'text/plain; charset=utf-8', 'types of the module'],
  ['.js.map', 'application/json; charset=utf-8', 'source map of the module'],
  ['.txt', 'text/plain; charset=utf-8', 'licences of what is bundled'],
];

/**
 * Serves the client library of this master's version to everybody, also to pages of other origins: it is no secret, and
 * gives no rights. [AC-5]
 *
 * @param folder the built library; where there is none, a sentence says so
 */
export async function addSdk(app: FastifyInstance, folder: string): Promise<void> {
  const files = filesIn(folder);
  const names = new Set(files.map(({ name }) => name));
  const ensureBuilt = (): void => {
    if (files.length > 0) return;
    throw new ServiceError(
      'not_found',
      'The client library is not built. Stop the master and run npm start, which builds what is missing.',
    );
  };
  app.get(SDK_ROUTES.page, (request, reply) => {
    ensureBuilt();
    return reply
      .header('cache-control', 'no-store')
      .header('content-security-policy', "default-src 'none'; style-src 'unsafe-inline'")
      .type('text/html; charset=utf-8')
      .send(sdkPage(originOf(request), files));
  });
  if (files.length === 0) {
    app.get(SDK_ROUTES.files, () => ensureBuilt());
    return;
  }
  await app.register(fastifyStatic, {
    root: folder,
    prefix: '/sdk/',
    decorateReply: false,
    preCompressed: true,
    cacheControl: false,
    allowedPath: (path) => names.has(path.slice(1)),
    setHeaders: (reply, path) => {
      const type = kindOf(path.replace(/\.(br|gz)$/, ''))?.[1];
      if (type !== undefined) reply.header('content-type', type);
      // A version is built again while it is developed.
      reply.header('cache-control', 'no-cache');
    },
  });
}

function filesIn(folder: string): readonly SdkFile[] {
  if (!existsSync(folder)) return [];
  return readdirSync(folder)
    .flatMap((name) => {
      const [, , about] = kindOf(name) ?? [];
      return about === undefined
        ? []
        : [{ name, about, sizeBytes: statSync(join(folder, name)).size }];
    })
    .sort(
      (a, b) =>
        KINDS.findIndex(([end]) => a.name.endsWith(end)) -
        KINDS.findIndex(([end]) => b.name.endsWith(end)),
    );
}

function kindOf(name: string): (typeof KINDS)[number] | undefined {
  return KINDS.find(([end]) => name.endsWith(end));
}

/** Origin by which the caller reached the master; its name was checked before. */
function originOf({ protocol, host }: FastifyRequest): string {
  return `${protocol}://${host}`;
}
