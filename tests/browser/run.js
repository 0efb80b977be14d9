// SPDX-License-Identifier: Apache-2.0
// node run.js MAKE_PAGES FOLDER: makes the pages and tests them. Exit status 77, with a reason, where they cannot be opened
// here.
import {spawnSync} from 'node:child_process';
import {existsSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const [make_pages, folder] = process.argv.slice(2);
const skip = reason => {
  console.log(`skipped: ${reason}`);
  process.exit(77);
};
if (!existsSync('/usr/bin/chromium')) skip('there is no /usr/bin/chromium; install Debian\'s package chromium, or call ./test');
if (!existsSync(join(here, 'node_modules/playwright-core')))
  skip(`playwright-core is not installed; call ./test, or npm ci --prefix ${here}`);

const made = spawnSync(make_pages, [folder], {stdio: 'inherit'});
if (made.status !== 0) process.exit(made.status ?? 1);
const tested = spawnSync(process.execPath, ['--test', '--test-concurrency=1', here], {
  stdio: 'inherit',
  env: {...process.env, LAMINA_PAGES: folder},
});
process.exit(tested.status ?? 1);
