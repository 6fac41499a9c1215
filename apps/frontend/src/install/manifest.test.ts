import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { routes } from '../routes.ts';
import { START_PATH } from './routes.ts';

const FRONTEND = join(import.meta.dirname, '../..');
const read = (path: string): Buffer => readFileSync(join(FRONTEND, path));

interface Icon {
  readonly src: string;
  readonly sizes: string;
  readonly type: string;
  readonly purpose?: string;
}
const manifest = JSON.parse(read('public/manifest.webmanifest').toString()) as {
  readonly start_url: string;
  readonly theme_color: string;
  readonly icons: readonly Icon[];
  readonly shortcuts: readonly { readonly url: string; readonly icons: readonly Icon[] }[];
};
const icons = [...manifest.icons, ...manifest.shortcuts.flatMap((shortcut) => shortcut.icons)];

it.each(icons)('$src is what the manifest says', ({ src, sizes, type }) => {
  const bytes = read(`public${src}`);
  if (type === 'image/svg+xml') {
    expect(sizes).toBe('any');
    expect(bytes.toString()).toContain('<svg');
    return;
  }
  // Width and height are at the beginning of a PNG.
  expect(bytes.subarray(1, 4).toString()).toBe('PNG');
  expect(`${bytes.readUInt32BE(16)}x${bytes.readUInt32BE(20)}`).toBe(sizes);
});

it('has an icon for every shape of a home screen', () => {
  const purposes = manifest.icons.map(({ purpose }) => purpose);
  expect(new Set(purposes)).toEqual(new Set(['any', 'maskable', 'monochrome']));
});

it('leads to pages that exist', () => {
  const paths = routes.map(({ path }) => path);
  expect(manifest.start_url).toBe(START_PATH);
  for (const path of [START_PATH, ...manifest.shortcuts.map(({ url }) => url)]) {
    expect(paths).toContain(path);
  }
});

it('has the colours of the themes', () => {
  const [, light, dark] = /--bg: light-dark\((\S+), (\S+)\)/.exec(
    read('src/styles/tokens.css').toString(),
  )!;
  const page = read('index.html').toString();
  expect(page).toContain(`(prefers-color-scheme: light)" content="${light}"`);
  expect(page).toContain(`(prefers-color-scheme: dark)" content="${dark}"`);
  expect(manifest.theme_color).toBe(dark);
});
