import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { delimiter, join } from 'node:path';

import { run } from './commands.mjs';
import { inRoot, readJson } from './repository.mjs';
import { StepFailed, commandStep } from './steps.mjs';

const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome'];

/** Chromium and the fonts its pages need, as Debian calls them. */
const browserPackages = ['chromium', 'chromium-headless-shell', 'fonts-liberation'];

/**
 * Commands that tests call, in stories with a network of their own, in clusters and in tests of the bridge, and Debian's packages
 * with them. Debian starts no service in a container; elsewhere its Mosquitto listens on loopback only.
 */
const tools = {
  certutil: 'libnss3-tools',
  ip: 'iproute2',
  mosquitto: 'mosquitto',
  'nats-server': 'nats-server',
};

const playwright = readJson(inRoot('e2e/package.json')).devDependencies['@playwright/test'];

const notFound = `The end-to-end tests need Chromium or Chrome, and none was found. Install one:
  Debian, Ubuntu   apt-get install chromium
  macOS, Windows   https://www.google.com/chrome
  anywhere         npx playwright@${playwright} install chromium
or give the path of one in UBII_CHROMIUM.`;

/**
 * Path of a browser for the tests. On Debian and Ubuntu, as root, it is installed when there is none, and
 * so are tools that some stories call; without these, they say themselves what is missing.
 *
 * @returns {Promise<string>}
 */
export async function ensureBrowser() {
  const found = findBrowser();
  const missing = [...(found === undefined ? browserPackages : []), ...missingTools()];
  if (missing.length > 0 && mayInstall()) {
    try {
      await install(missing);
    } catch (error) {
      if (found === undefined) throw error;
    }
  }
  const browser = found ?? findBrowser();
  if (browser === undefined) throw new StepFailed(notFound);
  return browser;
}

/**
 * Whether there is a Firefox for the stories that also run in one; on Debian and Ubuntu, as root, it is installed.
 *
 * @returns {Promise<boolean>}
 */
export async function ensureFirefox() {
  const isThere = () => existsSync(process.env.UBII_FIREFOX ?? '/usr/bin/firefox-esr');
  if (!isThere() && mayInstall()) await install(['firefox-esr']).catch(() => undefined);
  return isThere();
}

/** @param {readonly string[]} packages */
async function install(packages) {
  const env = { DEBIAN_FRONTEND: 'noninteractive' };
  await commandStep('update the package lists', () => run('apt-get', ['update', '-q'], { env }));
  await commandStep(`install ${packages.join(' and ')}`, () =>
    run('apt-get', ['install', '-y', '-q', '--no-install-recommends', ...packages], { env }),
  );
}

function missingTools() {
  const names = Object.entries(tools).filter(([name]) =>
    foldersOfPrograms().every((folder) => !existsSync(join(folder, name))),
  );
  return names.map(([, debianPackage]) => debianPackage);
}

function foldersOfPrograms() {
  const path = (process.env.PATH ?? '').split(delimiter).filter((folder) => folder !== '');
  // Where Debian has servers, which is in the path of root only.
  return process.platform === 'win32' ? path : [...path, '/usr/sbin'];
}

function findBrowser() {
  const given = process.env.UBII_CHROMIUM;
  if (given) {
    if (existsSync(given)) return given;
    throw new StepFailed(
      `UBII_CHROMIUM is ${given}, and there is no such file: correct or unset it.`,
    );
  }
  return [
    ...['/usr/bin', ...foldersOfPrograms()].flatMap((folder) =>
      names.map((name) => join(folder, name)),
    ),
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
    '/Applications/Chromium.app/Contents/MacOS/Chromium',
    ...['PROGRAMFILES', 'PROGRAMFILES(X86)', 'LOCALAPPDATA'].flatMap((name) => {
      const folder = process.env[name];
      return folder ? [join(folder, 'Google/Chrome/Application/chrome.exe')] : [];
    }),
    ...browserOfPlaywright(),
  ].find(works);
}

/** The browser that `playwright install` would have put on this machine. */
function browserOfPlaywright() {
  const require = createRequire(inRoot('e2e/package.json'));
  return [require('@playwright/test').chromium.executablePath()];
}

/** Ubuntu has a /usr/bin/chromium-browser that only says how to install a snap. */
function works(/** @type {string} */ path) {
  if (!existsSync(path)) return false;
  if (process.platform === 'win32') return true;
  try {
    execFileSync(path, ['--version'], { stdio: 'ignore', timeout: 20_000 });
    return true;
  } catch {
    return false;
  }
}

function mayInstall() {
  if (process.platform !== 'linux' || process.getuid?.() !== 0) return false;
  const release = existsSync('/etc/os-release') ? readFileSync('/etc/os-release', 'utf8') : '';
  return /^ID(_LIKE)?=.*\b(debian|ubuntu)\b/m.test(release) && existsSync('/usr/bin/apt-get');
}
