// SPDX-License-Identifier: MIT
// What the tests that run in node share.
const kSkipped = 77; // as lueur_node_test() has it
let failed = 0;

export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(kSkipped);
}

// Says in one line how the test went; what it throws is a failure.
export async function runTest(name, test) {
  const start = performance.now();
  try {
    await test();
    console.log(`ok      ${name} (${Math.round(performance.now() - start)} ms)`);
  } catch (error) {
    ++failed;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}

// What the process has to exit with.
export const exitCode = () => (failed === 0 ? 0 : 1);
