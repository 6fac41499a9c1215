import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';

import { ESLint } from 'eslint';

import { shortName } from './lint-rules.mjs';
import { inRoot, programFile, root } from './repository.mjs';

/** A fault for each rule. @type {readonly [rule: string, code: string][]} */
const FAULTS = [
  ['for-direction', 'for (let i = 0; i < 3; i--) console.error(i);'],
  ['no-async-promise-executor', 'export const p = new Promise(async (r) => r(1));'],
  [
    'no-case-declarations',
    'export function f(x) { switch (x) { case 1: let y = 1; return y; default: return 0; } }',
  ],
  ['no-compare-neg-zero', 'export const f = (x) => x === -0;'],
  ['no-cond-assign', 'export function f(x) { if (x = 1) return x; return 2; }'],
  ['no-constant-binary-expression', 'export const f = (a, b) => a + b ?? 3;'],
  ['no-constant-condition', 'export function f() { if (true) return 1; return 2; }'],
  ['no-control-regex', String.raw`export const r = /\x00/;`],
  ['no-debugger', 'debugger;'],
  ['no-dupe-else-if', 'export function f(a) { if (a) return 1; else if (a) return 2; return 3; }'],
  [
    'no-duplicate-case',
    'export function f(a) { switch (a) { case 1: return 2; case 1: return 3; default: return 4; } }',
  ],
  ['no-empty', 'export function f(a) { if (a) {} }'],
  ['no-empty-character-class', 'export const r = /a[]/;'],
  ['no-empty-pattern', 'export const {} = globalThis;'],
  ['no-empty-static-block', 'export class A { static {} }'],
  ['no-ex-assign', 'try { globalThis.x(); } catch (e) { e = 1; console.error(e); }'],
  ['no-extra-boolean-cast', 'export const f = (a) => (!!a ? 1 : 2);'],
  [
    'no-fallthrough',
    'export function f(a) { let b = 0; switch (a) { case 1: b = 1; case 2: b += 2; break; default: } return b; }',
  ],
  ['no-global-assign', 'Object = null;'],
  ['no-invalid-regexp', 'export const r = new RegExp("[");'],
  ['no-irregular-whitespace', 'export const a =\u00a01;'],
  ['no-loss-of-precision', 'export const a = 9007199254740993;'],
  ['no-misleading-character-class', 'export const r = /[👍]/;'],
  ['no-prototype-builtins', 'export const f = (a) => a.hasOwnProperty("x");'],
  ['no-regex-spaces', 'export const r = /a  b/;'],
  ['no-self-assign', 'export function f(a) { a = a; return a; }'],
  ['no-shadow-restricted-names', 'export function f(undefined) { return undefined; }'],
  ['no-sparse-arrays', 'export const a = [1, , 2];'],
  ['no-unassigned-vars', 'let a; export const f = () => a;'],
  ['no-unsafe-finally', 'export function f() { try { return 1; } finally { return 2; } }'],
  ['no-unsafe-optional-chaining', 'export const f = (a: number[]) => Math.max(...a?.b);'],
  ['no-unused-labels', 'export function f() { A: for (;;) { return 1; } }'],
  ['no-unused-private-class-members', 'export class A { #x = 1; }'],
  ['no-useless-assignment', 'export function f() { let a = 1; a = 2; return a; }'],
  ['no-useless-backreference', String.raw`export const r = /(?:\1(a))/;`],
  ['no-useless-catch', 'try { globalThis.x(); } catch (e) { throw e; }'],
  ['no-useless-escape', String.raw`export const a = "\d";`],
  [
    'preserve-caught-error',
    'export function f() { try { return g(); } catch (error) { if (error instanceof TypeError) { throw new RangeError(String(error)); } return 1; } } const g = () => 1;',
  ],
  ['require-yield', 'export function* f() { return 1; }'],
  ['use-isnan', 'export const f = (a) => a === NaN;'],
  ['valid-typeof', 'export const f = (a) => typeof a === "strnig";'],
  ['@typescript-eslint/no-array-constructor', 'export const a = Array?.(1, 2);'],
  ['@typescript-eslint/no-this-alias', 'export function f() { const self = this; return self; }'],
  ['@typescript-eslint/no-unused-expressions', 'export const f = (a) => { a; };'],
  ['@typescript-eslint/no-unused-vars', 'const a = 1; export type B = typeof a;'],
  ['@typescript-eslint/no-require-imports', 'export const a = require("node:fs");'],
  ['@typescript-eslint/ban-ts-comment', '// @ts-ignore\nexport const a = 1;'],
  ['@typescript-eslint/triple-slash-reference', '/// <reference path="x" />\nexport const a = 1;'],
  ['no-var', 'var a = 1; export const b = () => a;'],
  ['prefer-const', 'let a; a ??= 1; export const b = a;'],
  ['prefer-rest-params', 'export function f() { return arguments; }'],
  [
    'prefer-spread',
    'export const f = (a: (...x: number[]) => void, b: number[]) => a.apply(undefined, b);',
  ],
  ['@typescript-eslint/no-duplicate-enum-values', 'export enum E { A = 1, B = 1 }'],
  ['@typescript-eslint/no-empty-object-type', 'export const a: {} = 1;'],
  ['@typescript-eslint/no-explicit-any', 'export const a: any = 1;'],
  ['@typescript-eslint/no-extra-non-null-assertion', 'export const f = (a?: string) => a!!;'],
  ['@typescript-eslint/no-misused-new', 'export interface A { new (): A; }'],
  ['@typescript-eslint/no-namespace', 'export namespace A { export const b = 1; }'],
  [
    '@typescript-eslint/no-non-null-asserted-optional-chain',
    'export const f = (a?: { b?: 1 }) => a?.b!;',
  ],
  [
    '@typescript-eslint/no-unnecessary-type-constraint',
    'export const f = <T extends unknown>(a: T) => a;',
  ],
  [
    '@typescript-eslint/no-unsafe-declaration-merging',
    'export interface A { a: 1 } export class A { b = 1; }',
  ],
  ['@typescript-eslint/no-unsafe-function-type', 'export const a: Function = () => 1;'],
  ['@typescript-eslint/no-wrapper-object-types', 'export const a: String = "x";'],
  ['@typescript-eslint/prefer-as-const', 'export const a = <"x">"x";'],
  [
    '@typescript-eslint/prefer-namespace-keyword',
    'module A { export const a = 1; } export const b = A;',
  ],
  [
    '@typescript-eslint/consistent-type-imports',
    'import { Stats } from "node:fs"; export const a: Stats | undefined = undefined;',
  ],
  ['eqeqeq', 'export const f = (a: number) => a == 1;'],
  ['no-eval', 'export const f = (a: string) => eval(a);'],
  ['no-implied-eval', 'setTimeout("x()", 1);'],
  ['no-new-func', 'export const f = new Function("a", "return a");'],
  ['no-console', 'console.info(1);'],
  ['ubii/no-native-patterns', 'export const f = (a: string) => new RegExp(a);'],
  ['ubii/no-hand-written-plurals', 'export const f = (a: number) => (a === 1 ? "one" : "many");'],
  ['ubii/no-spread-literals', 'export const a = { ...{ b: 1 }, c: 2 };'],
];

/** Where a package must not look: folder, import. */
const ARROWS = [
  ['packages/words/src', '@ubii/master'],
  ['packages/words/src', '@ubii/modules/set'],
  ['packages/words/src', 'vue'],
  ['packages/proto/src', '@ubii/client-web'],
  ['packages/client-web/src', '@ubii/modules'],
  ['packages/pm-sandbox/src', 'node:fs/promises'],
  ['packages/pm-sandbox/src', '../node/threads.ts'],
  ['packages/modules/src', '@ubii/client-web/core'],
  ['packages/vision/src', 'esbuild'],
  ['packages/vision/scripts', 'vue'],
  ['apps/bridge/src', '@ubii/node'],
  ['demos/ubi-party/src/sim', 'ws'],
  ['demos/ubi-party/src/net', '../view/stage.ts'],
  ['demos/ubi-party/src/phone', 'three/addons'],
  ['apps/master/src/adapters', '@ubii/client-web'],
  ['apps/master/src/core', '../adapters/http.ts'],
  ['apps/frontend/src', '@ubii/master/core'],
  ['robustness/src', '@ubii/frontend'],
];

/** Use of what a folder must not have: folder, code. */
const USES = [
  ['packages/vision/src', 'export const f = () => fetch;'],
  ['apps/master/src/core', 'export const f = () => setTimeout;'],
  ['apps/master/src/core', 'export const f = () => Date.now();'],
  ['demos/ubi-party/src/sim', 'export const f = () => Math.sin(1);'],
  ['apps/frontend/src', 'export const f = (date: Date) => date.toLocaleString();'],
];

const folder = mkdtempSync(join(tmpdir(), 'ubii-lint-'));
after(() => rmSync(folder, { recursive: true }));

/** Lints files with the rules of the repository. @param {ReadonlyMap<string, string>} files @returns {(file: string) => string[]} names of the rules that found something */
function findingsOf(files) {
  const config = JSON.stringify(new URL('../../oxlint.config.mjs', import.meta.url).href);
  writeFileSync(join(folder, 'oxlint.config.mjs'), `export { default } from ${config};\n`);
  for (const [file, code] of files) {
    mkdirSync(dirname(join(folder, file)), { recursive: true });
    writeFileSync(join(folder, file), `${code}\n`);
  }
  const args = [programFile('', 'oxlint'), '--config', 'oxlint.config.mjs', '--format', 'json'];
  const { stdout } = spawnSync(process.execPath, args, { cwd: folder, encoding: 'utf8' });
  /** @type {{ diagnostics: { filename: string, code?: string }[] }} */
  const { diagnostics } = JSON.parse(stdout);
  return (file) =>
    diagnostics
      .filter(({ filename }) => filename === file)
      .map(({ code = '' }) => /\(([\w-]+)\)/.exec(code)?.[1] ?? '');
}

test('oxlint finds a fault of each rule in TypeScript', async () => {
  const file = (/** @type {string} */ rule) => `apps/node/src/${rule.replace(/\W/g, '-')}.ts`;
  const find = findingsOf(new Map(FAULTS.map(([rule, code]) => [file(rule), code])));
  const missed = FAULTS.map(([rule]) => rule).filter(
    (rule) => !find(file(rule)).includes(shortName(rule)),
  );
  assert.deepEqual(missed, []);
});

test('each rule of ESLint for TypeScript has a fault here', async () => {
  const { rules } = await new ESLint({ cwd: root }).calculateConfigForFile(
    inRoot('apps/node/src/main.ts'),
  );
  const planted = new Set([
    ...FAULTS.map(([rule]) => rule),
    // Planted for each folder
    '@typescript-eslint/no-restricted-imports',
    // Refused by the parser
    ...['no-delete-var', 'no-nonoctal-decimal-escape', 'no-octal'],
  ]);
  const names = Object.keys(rules).filter((name) => rules[name][0] > 0 && !name.startsWith('vue/'));
  assert.deepEqual(
    names.filter((name) => !planted.has(name)),
    [],
  );
});

test('oxlint keeps to the arrows between folders', () => {
  const imports = ARROWS.flatMap(([at, name]) =>
    [
      `import { a } from '${name}';`,
      `import type { A } from '${name}';`,
      `export * from '${name}';`,
    ].map(
      (code, index) =>
        /** @type {const} */ ([`${at}/${name.replace(/\W/g, '-')}-${index}.ts`, code]),
    ),
  );
  const uses = USES.map(
    ([at, code], index) => /** @type {const} */ ([`${at}/use-${index}.ts`, code]),
  );
  const find = findingsOf(new Map([...imports, ...uses]));
  const passed = [...imports, ...uses].filter(
    ([file]) => !find(file).some((rule) => rule.startsWith('no-restricted-')),
  );
  assert.deepEqual(passed, []);
});
