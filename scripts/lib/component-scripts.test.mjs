import assert from 'node:assert/strict';
import { test } from 'node:test';

import { nameComponents, scriptOf } from './component-scripts.mjs';

test('the scripts of a component stand at their lines and columns, and nothing else is left', () => {
  const source = `<script lang="ts">
export type Kind = 'a';
</script>

<script setup lang="ts">const kind = 'a';</script>

<template><p>{{ kind }}</p></template>
`;
  const script = scriptOf(source);
  assert.equal(script.length, source.length);
  assert.equal(script.indexOf('export type Kind'), source.indexOf('export type Kind'));
  assert.equal(script.indexOf('const kind'), source.indexOf('const kind'));
  assert.equal(script.trim().replaceAll(/\s+/g, ' '), "export type Kind = 'a'; const kind = 'a';");
});

test('findings have the path of the component', () => {
  assert.equal(
    nameComponents(',-[src/home/HomePage.vue.ts:3:1]', 'apps/frontend'),
    ',-[apps/frontend/src/home/HomePage.vue:3:1]',
  );
});
