import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { describe, expect, it, onTestFinished } from 'vitest';
import {
  buildBrowserWorkers,
  sandboxWorkersPlugin,
  SANDBOX_WORKER_FILES as BUILT_FILES,
} from '../build/index.mjs';
import { SANDBOX_WORKER_FILES } from '../src/index.ts';
import { WORKER_FILE } from './build-worker.ts';

type Middleware = (
  request: { url: string },
  response: { setHeader(name: string, value: string): void; end(text: string): void },
  next: () => void,
) => void;

describe('built workers', () => {
  it('import nothing at run time but what the platform has', () => {
    const text = readFileSync(WORKER_FILE, 'utf8');
    const imports = [...text.matchAll(/(?:^|[;}\s])import[^;()]*?from\s*"([^"]+)"/g)].map(
      ([, name]) => name,
    );
    expect(imports.filter((name) => !name!.startsWith('node:'))).toEqual([]);
    expect(text).toContain('MIT licence');
  });

  it('of browsers lie where their policies are sent', async () => {
    expect(BUILT_FILES).toEqual(SANDBOX_WORKER_FILES);
    const folder = mkdtempSync(join(tmpdir(), 'ubii-workers-'));
    onTestFinished(() => rmSync(folder, { recursive: true }));
    await buildBrowserWorkers(folder);
    for (const { path, csp } of Object.values(SANDBOX_WORKER_FILES)) {
      expect(readFileSync(join(folder, path), 'utf8').length).toBeGreaterThan(10_000);
      expect(csp).toContain("default-src 'none'");
      expect(csp).not.toMatch(/sandbox|'self'|\*|connect-src/);
    }
    expect(SANDBOX_WORKER_FILES.sandboxed.csp).not.toContain("'unsafe-eval'");
  });

  it('come with their policies in development', async () => {
    let serve!: Middleware;
    const plugin = sandboxWorkersPlugin() as unknown as {
      configureServer(server: { middlewares: { use(given: Middleware): void } }): void;
    };
    plugin.configureServer({ middlewares: { use: (given) => void (serve = given) } });
    const { path, csp } = SANDBOX_WORKER_FILES.trusted;
    const headers: Record<string, string> = {};
    const text = await new Promise<string>((resolve, reject) =>
      serve(
        { url: `${path}?v=1` },
        { setHeader: (name, value) => void (headers[name] = value), end: resolve },
        () => reject(new Error('not served')),
      ),
    );
    expect(text.length).toBeGreaterThan(10_000);
    expect(headers['Content-Security-Policy']).toBe(csp);
    const isPassedOn = await new Promise((resolve) =>
      serve(
        { url: '/sandbox/other.js' },
        { setHeader: () => undefined, end: () => resolve(false) },
        () => resolve(true),
      ),
    );
    expect(isPassedOn).toBe(true);
  });
});
