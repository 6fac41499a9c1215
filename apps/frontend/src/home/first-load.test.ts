import { describe, expect, it } from 'vitest';
// @ts-expect-error -- a plugin of the build, in JavaScript
import { firstLoad } from '../../first-load-plugin.js';

const chunk = (fileName: string, changes: object = {}) => ({
  type: 'chunk',
  fileName,
  code: `export const name = ${JSON.stringify(fileName)};`,
  isEntry: false,
  facadeModuleId: null,
  imports: [],
  ...changes,
});
const measure = firstLoad as (bundle: object) => { fileName: string; bytes: number }[];
const entry = chunk('index.js', { isEntry: true, imports: ['vue.js'] });
const home = chunk('HomePage.js', {
  facadeModuleId: '/src/home/HomePage.vue',
  imports: ['clients.js', 'vue.js'],
});

describe('firstLoad()', () => {
  it('counts the entry, Home, and what they import at once, each once', () => {
    const bundle = {
      'index.js': entry,
      'HomePage.js': home,
      'vue.js': chunk('vue.js', { code: 'x'.repeat(10) + Math.PI }),
      'clients.js': chunk('clients.js', { imports: ['names.js'] }),
      'names.js': chunk('names.js'),
      'TopicsPage.js': chunk('TopicsPage.js', { imports: ['plots.js'] }),
      'plots.js': chunk('plots.js'),
      'style.css': { type: 'asset' },
    };
    const files = measure(bundle);
    expect(files.map(({ fileName }) => fileName).sort()).toEqual(
      ['HomePage.js', 'clients.js', 'index.js', 'names.js', 'vue.js'].sort(),
    );
    for (const { bytes } of files) expect(bytes, 'with headers').toBeGreaterThan(1500);
  });

  it('fails when the build has no Home', () => {
    expect(() => measure({ 'index.js': entry, 'vue.js': chunk('vue.js') })).toThrow('no chunk');
  });
});
