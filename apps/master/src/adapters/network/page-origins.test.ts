import { expect, it } from 'vitest';
import { originsOf } from './page-origins.ts';

it('[CU-90] takes the origins of web addresses, and nothing that could end a header', () => {
  expect(
    originsOf([
      'http://10.0.0.5:8080',
      'http://10.0.0.5:8080/ubii',
      'HTTPS://A.example:443/',
      'https://10.0.0.6:8080',
      'ftp://a',
      'javascript:alert(1)',
      '',
      "http://b.example/; script-src 'unsafe-inline'\r\nx: y",
    ]),
  ).toEqual([
    'http://10.0.0.5:8080',
    'https://a.example',
    'http://a.example:443',
    'https://10.0.0.6:8080',
    'http://10.0.0.6:8080',
    'http://b.example',
  ]);
});
