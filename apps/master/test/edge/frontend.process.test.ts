import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync, gzipSync } from 'node:zlib';
import { SANDBOX_WORKER_FILES } from '@ubii/pm-sandbox';
import { temporaryFolder } from '@ubii/program/testing';
import { describe, expect, it, vi } from 'vitest';

import { send, startEdgeMaster } from './edge-master.ts';

// A whole master each: minutes on a busy machine are no fault of it.
vi.setConfig({ testTimeout: 60_000 });

const PAGE = '<!doctype html><title>frontend</title>';
const SCRIPT = 'console.log(1)';
const asPage = { accept: 'text/html,*/*' };

function builtFrontend(): string {
  const folder = temporaryFolder();
  mkdirSync(join(folder, 'assets'));
  writeFileSync(join(folder, 'index.html'), PAGE);
  writeFileSync(join(folder, 'assets', 'main-abc123.js'), SCRIPT);
  writeFileSync(join(folder, 'assets', 'main-abc123.js.br'), brotliCompressSync(SCRIPT));
  writeFileSync(join(folder, 'assets', 'main-abc123.js.gz'), gzipSync(SCRIPT));
  return folder;
}

describe('the frontend', () => {
  it.each(['/', '/topics', '/topics/a/b', '/clients?x=1', '/services'])(
    'is one document for %s',
    async (path) => {
      const { port } = await startEdgeMaster({ frontendFolder: builtFrontend() });
      const { status, headers, body } = await send(port, path, { headers: asPage });
      expect(status).toBe(200);
      expect(body.toString()).toBe(PAGE);
      expect(headers['content-type']).toBe('text/html; charset=utf-8');
      expect(headers['cache-control']).toBe('no-cache');
      expect(headers['content-security-policy']).toContain("default-src 'self'");
      expect(headers['content-security-policy']).not.toMatch(
        /unsafe-eval'.*script|script-src[^;]*'unsafe-inline'/,
      );
      expect(headers['x-content-type-options']).toBe('nosniff');
    },
  );

  it('may use the sensors of its devices, and nothing that it does not need [AC-67]', async () => {
    const { port } = await startEdgeMaster({ frontendFolder: builtFrontend() });
    for (const path of ['/', '/assets/main-abc123.js', '/health', '/nothing.js']) {
      const { headers } = await send(port, path, { headers: asPage });
      expect(headers['cross-origin-resource-policy']).toBe('same-origin');
      expect(headers['cross-origin-opener-policy']).toBe('same-origin');
      expect(headers['referrer-policy']).toBe('no-referrer');
      const policy = String(headers['permissions-policy']).split(', ');
      // Smart device, camera, gamepad; the screen that stays on, copying, big screens, tones.
      for (const used of [
        ...['accelerometer', 'gyroscope', 'magnetometer', 'camera', 'microphone', 'geolocation'],
        ...['gamepad', 'screen-wake-lock', 'clipboard-read', 'clipboard-write', 'fullscreen'],
        'autoplay',
      ]) {
        expect(policy).toContain(`${used}=(self)`);
      }
      for (const unused of ['usb', 'serial', 'hid', 'midi', 'payment', 'display-capture']) {
        expect(policy).toContain(`${unused}=()`);
      }
      expect(String(headers['permissions-policy'])).not.toContain('*');
    }
  });

  it('answers pages of other origins that may call, as before [SV-8] [AC-67]', async () => {
    const { port } = await startEdgeMaster();
    const { status, headers } = await send(port, '/services/json', {
      method: 'POST',
      headers: { 'content-type': 'application/json', origin: 'http://localhost:5173' },
      body: '{"topic":"/services/server_configuration"}',
    });
    expect(status).toBe(200);
    expect(headers['access-control-allow-origin']).toBe('http://localhost:5173');
  });

  it('answers HEAD, and "not modified" to those who have it', async () => {
    const { port } = await startEdgeMaster({ frontendFolder: builtFrontend() });
    const { status, headers } = await send(port, '/', { method: 'HEAD', headers: asPage });
    expect(status).toBe(200);
    const again = await send(port, '/', {
      headers: { ...asPage, 'if-none-match': String(headers.etag) },
    });
    expect(again.status).toBe(304);
  });

  it.each([
    ['br', 'br'],
    ['gzip', 'gzip'],
    ['gzip, br', 'br'],
    ['identity', undefined],
  ])('has files compressed beforehand: %s', async (accepted, expected) => {
    const { port } = await startEdgeMaster({ frontendFolder: builtFrontend() });
    const { status, headers } = await send(port, '/assets/main-abc123.js', {
      headers: { 'accept-encoding': accepted },
    });
    expect(status).toBe(200);
    expect(headers['content-encoding']).toBe(expected);
    expect(headers['content-type']).toContain('javascript');
    expect(headers['cache-control']).toContain('immutable');
  });

  it('lets itself be installed: manifest and service worker are asked for each time', async () => {
    const folder = builtFrontend();
    writeFileSync(join(folder, 'manifest.webmanifest'), '{}');
    writeFileSync(join(folder, 'service-worker.js'), SCRIPT);
    const { port } = await startEdgeMaster({ frontendFolder: folder });
    for (const [path, type] of [
      ['/manifest.webmanifest', 'application/manifest+json'],
      ['/service-worker.js', 'javascript'],
    ] as const) {
      const { status, headers } = await send(port, path);
      expect(status).toBe(200);
      expect(headers['content-type']).toContain(type);
      expect(headers['cache-control']).toBe('no-cache');
    }
  });

  it('gives workers with modules a policy of their own, compressed or not [PM-52]', async () => {
    const folder = builtFrontend();
    mkdirSync(join(folder, 'sandbox'));
    const { port } = await startEdgeMaster({ frontendFolder: folder });
    for (const { path, csp } of Object.values(SANDBOX_WORKER_FILES)) {
      writeFileSync(join(folder, path), SCRIPT);
      writeFileSync(join(folder, `${path}.br`), brotliCompressSync(SCRIPT));
      for (const accepted of ['br', 'identity']) {
        const { status, headers } = await send(port, path, {
          headers: { 'accept-encoding': accepted },
        });
        expect(status).toBe(200);
        expect(headers['content-security-policy']).toBe(csp);
      }
    }
  });

  it.each(['/assets/main-old.js', '/../secret', '/%2e%2e/secret', '/assets/%00'])(
    'has nothing at %s',
    async (path) => {
      const { port } = await startEdgeMaster({ frontendFolder: builtFrontend() });
      expect((await send(port, path)).status).toBeGreaterThanOrEqual(400);
    },
  );

  it('is missing in words when it was not built', async () => {
    const { port } = await startEdgeMaster();
    const { status, body } = await send(port, '/topics', { headers: asPage });
    expect(status).toBe(503);
    expect(body.toString()).toContain('npm start');
  });
});
