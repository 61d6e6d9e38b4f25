#!/usr/bin/env node
// Validates glTF files, where `npm install gltf-validator` was run in this folder or one above: `tools/glb_check.js film.glb …`
//
// Fails if the validator of the Khronos Group finds an error or a warning in one of the files.
"use strict";

const fs = require("fs");
const path = require("path");
const validator = require("gltf-validator");

async function check(file) {
  const { issues, info } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
  const { numErrors, numWarnings, numInfos, numHints, messages } = issues;
  console.log(`${path.basename(file)}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints; `
    + `${info.animationCount} animations, ${info.materialCount} materials, ${info.totalVertexCount} vertices, ${info.totalTriangleCount} triangles`);
  for (const { code, message, pointer } of messages) console.log(`  ${code} ${pointer}: ${message}`);
  return numErrors + numWarnings;
}

Promise.all(process.argv.slice(2).map(check)).then((counts) => {
  if (counts.length === 0) throw new Error("which files?");
  process.exitCode = counts.some((count) => count > 0) ? 1 : 0;
}).catch((error) => {
  console.error(error.message);
  process.exitCode = 1;
});
