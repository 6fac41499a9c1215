import assert from 'node:assert/strict';
import { test } from 'node:test';

import { textsOfScreens } from './texts-of-screens.mjs';

const page = {
  path: 'apps/frontend/src/home/HomePage.vue',
  source: `<script setup lang="ts">
// Not on the screen, but a sentence.
const title = count > 1 ? \`Of \${count} sessions none runs\` : 'One session is there';
</script>
<template>
  <h1 aria-label="What runs">{{ title }}</h1>
  <p>Start {{ name }} here</p>
  <p>Start {{ name }} here</p>
</template>
`,
};

test('texts on screens are listed by feature, once for each file, with … for what is put in', () => {
  const texts = textsOfScreens([page, { path: 'docs/a.md', source: 'No text of a screen.' }]);
  assert.deepEqual(
    [...texts],
    [
      [
        'apps/frontend/src/home',
        [
          'apps/frontend/src/home/HomePage.vue:3 Of … sessions none runs',
          'apps/frontend/src/home/HomePage.vue:3 One session is there',
          'apps/frontend/src/home/HomePage.vue:6 What runs',
          'apps/frontend/src/home/HomePage.vue:7 Start … here',
        ],
      ],
    ],
  );
});

test('the list can be of one folder', () => {
  assert.equal(textsOfScreens([page], 'apps/frontend/src/graph').size, 0);
});
